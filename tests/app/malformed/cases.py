"""Malformed files: a name, what is done to a good file, and what nineline-cli must say.

A change is (line, new text of the line), or a function of the whole file's bytes. The answer is (status, line): the
line that the message must name, None where the whole file is at fault. Status 0 stands only where the file is harmless,
with the reason beside it.
"""

MEBIBYTE = 1 << 20


def only(*lines):
    """Nothing but these lines."""
    return lambda _: "\n".join(lines).encode() + b"\n"


def cut(count):
    return lambda good: good[:count]


def before(prefix):
    return lambda good: prefix + good


def coded(encoding):
    return lambda good: good.decode().encode(encoding)


def line_of(number, raw):
    """A line of raw bytes."""
    def change(good):
        lines = good.split(b"\n")
        lines[number - 1] = raw
        return b"\n".join(lines)
    return change


NC = [
    ("word_without_number", (8, "X F800.")),
    ("two_points", (8, "X110.0.0 F800.")),
    ("two_signs", (8, "X--110. F800.")),
    ("letter_in_number", (8, "X11O. F800.")),
    ("infinity", (8, "Xinf F800.")),
    ("not_a_number", (8, "Xnan F800.")),
    ("exponent", (11, "G00 Z1e2 M09")),
    ("hexadecimal", (8, "X0x10 F800.")),
    ("decimal_comma", (8, "X110,000 F800.")),
    ("number_without_address", (8, "110.000 F800.")),
    ("huge_number", (8, "X" + "9" * 400 + " F800.")),
    ("number_of_a_thousand_digits", (8, "X110." + "0" * 1000 + "x F800.")),
    ("axis_twice", (8, "X110. X120. F800.")),
    ("no_such_axis", (8, "A110. F800.")),
    ("open_comment", (8, "X110. (NO END")),
    ("nested_comment_left_open", (8, "X110. (A (B) C( F800.")),
    ("closed_comment_only", (8, "X110. ) F800.")),
    ("curly_brackets", (8, "X{110} F800.")),
    ("question_mark", (8, "X? F800.")),
    ("open_expression", (8, "X[1+2 F800.")),
    ("empty_expression", (8, "X[] F800.")),
    ("division_by_zero", (8, "X[1/0] F800.")),
    ("unset_variable", (8, "X#101 F800.")),
    ("variable_without_number", (8, "# = 5")),
    ("assignment_without_value", (8, "#1=")),
    ("root_of_minus_one", (8, "X[SQRT[0-1]] F800.")),
    ("unknown_function", (8, "X[WURZEL[4]] F800.")),
    ("goto_nowhere", (8, "GOTO 999")),
    ("goto_itself", (8, "N8 GOTO 8")),
    ("while_without_end", (11, "WHILE [1 EQ 1] DO1")),
    ("end_without_while", (8, "END1")),
    ("if_without_condition", (8, "IF GOTO 8")),
    ("call_of_no_program", (8, "M98 P9999")),
    ("return_in_main", (8, "M99 P")),
    ("unknown_motion", (8, "G887 X110.")),
    ("code_with_fraction", (8, "G1.37 X110.")),
    ("negative_code", (8, "G-1 X110.")),
    ("two_motion_codes", (8, "G01 G02 X110. F800.")),
    ("arc_without_centre", (8, "G02 X110. Y10. F800.")),
    ("arc_radius_too_small", (8, "G02 X110. Y10. R2. F800.")),
    ("arc_centre_beside", (8, "G02 X110. Y10. I3. J0. F800.")),
    ("arc_radius_zero", (8, "G02 X110. Y10. R0. F800.")),
    ("negative_feed", (8, "X110. F-800.")),
    ("null_byte", line_of(8, b"X11\x000. F800.")),
    ("control_bytes", line_of(8, b"X110. \x01\x02\x07")),
    ("not_utf8", line_of(8, b"X110.\xff\xfe F800.")),
    ("utf16", coded("utf-16")),
    ("utf8_letters", (8, "Ж110. F800.")),
    ("line_of_two_mebibytes", line_of(8, b"X" + b"1" * (2 * MEBIBYTE))),
    ("another_file", only('{"format": "nineline-model/1"}')),
    ("a_picture", before(b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR")),
    ("outside_travel", (8, "X9999. F800.")),
]

MODEL = [
    ("empty", cut(0)),
    ("cut_off", cut(200)),
    ("no_json", only("effects: none")),
    ("trailing_text", lambda good: good + b"and more\n"),
    ("comma_missing", (2, ' "format": "nineline-model/1"')),
    ("comma_too_many", (12, '  {"effect": "location", "component": "B0Z", "value_arcsec": 10},')),
    ("key_twice", (7, '   "spacing_mm": 50, "start_mm": 0,')),
    ("an_array", only("[1, 2, 3]")),
    ("a_number", only("17")),
    ("nesting_without_end", only("[" * 100_000)),
    ("not_utf8", line_of(9, b'   "interpolation": "linear", "source": "\xff\xfe"},')),
    ("utf16", coded("utf-16")),
    ("format_missing", (2, ' "form": "nineline-model/1",')),
    ("format_newer", (2, ' "format": "nineline-model/2",')),
    ("machine_missing", (3, ' "machines": "generic-3axis",')),
    ("machine_unknown", (3, ' "machine": "generic-4axis",')),
    ("machine_a_number", (3, ' "machine": 3,')),
    ("effects_missing", (4, ' "effect": [')),
    ("effect_unknown", (10, '  {"effect": "backlsh", "joint": "Y",')),
    ("joint_unknown", (5, '  {"effect": "table", "joint": "C", "component": "EXC",')),
    ("component_of_another_joint", (5, '  {"effect": "table", "joint": "X", "component": "EXY",')),
    ("component_unknown", (5, '  {"effect": "table", "joint": "X", "component": "EQX",')),
    ("start_missing", (6, '   "begin_mm": 0,')),
    ("start_in_degrees", (6, '   "start_deg": 0,')),
    ("spacing_zero", (7, '   "spacing_mm": 0,')),
    ("spacing_negative", (7, '   "spacing_mm": -50,')),
    ("spacing_text", (7, '   "spacing_mm": "50",')),
    ("values_empty", (8, '   "values_um": [],')),
    ("values_text", (8, '   "values_um": [0, 10, "twenty", 30, 40],')),
    ("values_null", (8, '   "values_um": [0, 10, null, 30, 40],')),
    ("values_nan", (8, '   "values_um": [0, 10, NaN, 30, 40],')),
    ("values_infinite", (8, '   "values_um": [0, 10, 1e999, 30, 40],')),
    ("values_in_metres", (8, '   "values_um": [0, 10, 2e7, 30, 40],')),
    ("values_of_another_unit", (8, '   "values_arcsec": [0, 10, 20, 30, 40],')),
    ("interpolation_unknown", (9, '   "interpolation": "quintic", "source": "measured"},')),
    ("parameter_missing", (11, '   "parameters": {"breadth": {"value": 3.2, "sigma": 0.2, "unit": "um"}}},')),
    ("parameter_text", (11, '   "parameters": {"width": {"value": "3.2", "sigma": 0.2, "unit": "um"}}},')),
    ("parameter_of_another_unit", (11, '   "parameters": {"width": {"value": 3.2, "unit": "mm"}}},')),
    ("location_without_value", (12, '  {"effect": "location", "component": "B0Z"}')),
    ("location_as_table", (12, '  {"effect": "table", "component": "B0Z", "value_arcsec": 10}')),
]

MACHINE = [
    ("empty", cut(0)),
    ("cut_off", cut(300)),
    ("format_of_a_model", (2, ' "format": "nineline-model/1",')),
    ("id_missing", (3, ' "ident": "mill",')),
    ("id_a_number", (3, ' "id": 3,')),
    ("axis_unknown", (6, '  {"axis": "Q", "type": "linear", "direction": [-1, 0, 0]},')),
    ("axis_twice", (10, '  {"axis": "X", "type": "linear", "direction": [0, 0, 1]}')),
    ("type_unknown", (6, '  {"axis": "X", "type": "lineal", "direction": [-1, 0, 0]},')),
    ("type_missing", (6, '  {"axis": "X", "direction": [-1, 0, 0]},')),
    ("direction_missing", (6, '  {"axis": "X", "type": "linear"},')),
    ("direction_of_two", (6, '  {"axis": "X", "type": "linear", "direction": [-1, 0]},')),
    ("direction_zero", (6, '  {"axis": "X", "type": "linear", "direction": [0, 0, 0]},')),
    ("direction_too_long", (6, '  {"axis": "X", "type": "linear", "direction": [-2, 0, 0]},')),
    ("travel_reversed", (6, '  {"axis": "X", "type": "linear", "direction": [-1, 0, 0], "travel": [500, -500]},')),
    ("travel_of_one", (6, '  {"axis": "X", "type": "linear", "direction": [-1, 0, 0], "travel": [500]},')),
    ("offset_text", (6, '  {"axis": "X", "type": "linear", "direction": [-1, 0, 0], "offset_mm": "none"},')),
    ("tool_axis_zero", (12, ' "tool": {"tip_mm": [0, 0, 0], "axis": [0, 0, 0]}')),
    ("chain_missing", (9, ' "tool_chian": [')),
]

THREAD = [
    ("empty", cut(0)),
    ("format_missing", (2, ' "version": "nineline-thread/1",')),
    ("diameter_missing", (4, ' "diametre_mm": 10,')),
    ("diameter_text", (4, ' "diameter_mm": "M10",')),
    ("diameter_zero", (4, ' "diameter_mm": 0,')),
    ("pitch_negative", (5, ' "pitch_mm": -1.5,')),
    ("pitch_larger_than_the_bar", (5, ' "pitch_mm": 15,')),
    ("length_infinite", (6, ' "length_mm": 1e999,')),
    ("length_astronomical", (6, ' "length_mm": 1e18,')),
    ("starts_zero", (7, ' "starts": 0,')),
    ("starts_a_fraction", (7, ' "starts": 1.5,')),
    ("hand_unknown", (8, ' "hand": "both",')),
    ("infeed_zero", (9, ' "infeed_mm": 0,')),
    ("infeed_absurd", (9, ' "infeed_mm": 1e-15,')),
    ("block_step_negative", (10, ' "block_step_deg": -90,')),
    ("decimals_absurd", (11, ' "decimals": 400,')),
    ("codes_a_list", (12, ' "codes": [1, 2]')),
    ("code_a_number", (12, ' "codes": {"wheel_on": 3}')),
]
