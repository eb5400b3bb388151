#include "core/nc/block_writer.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/nc/interpreter.h"
#include "core/nc/tokenizer.h"

namespace nineline::nc {
namespace {

const NumberStyle kStyle{3, 3, true, false};

Block blockOf(std::string_view text, Dialect dialect = Dialect::Fanuc) {
  Block block;
  block.line = 2;
  block.text = text;
  EXPECT_TRUE(readPlainWords(block, dialect)) << text;
  return block;
}

std::string written(const BlockEditor& editor) {
  std::string out;
  editor.appendTo(out);
  return out;
}

TEST(BlockWriter, ReplacesValuesAndKeepsEverythingElse) {
  const Block block = blockOf("N10  G01 X 1.5(a X9)Y-2. F100. M8 ; tail");
  BlockEditor editor(block, kStyle);
  ASSERT_TRUE(editor.setValue(*block.find('Y'), -2.0004, 4));
  ASSERT_TRUE(editor.setValue(*block.find('X'), 1.25, 4));
  EXPECT_EQ(written(editor), "N10  G01 X 1.25(a X9)Y-2.0004 F100. M8 ; tail");
  EXPECT_EQ(written(BlockEditor(block, kStyle)), block.text);
}

TEST(BlockWriter, AddsWordsBehindTheLastAxisWord) {
  const Block spaced = blockOf("G01 X1. F100. M8 (c)");
  BlockEditor editor(spaced, kStyle);
  ASSERT_TRUE(editor.addWord('Y', 0, 2.0, 3));
  ASSERT_TRUE(editor.addWord('C', 2, -0.5, 3));
  EXPECT_EQ(written(editor), "G01 X1. Y2. C2=-0.5 F100. M8 (c)");
  const Block tight = blockOf("N5G1X1.F100.");
  BlockEditor tight_editor(tight, kStyle);
  ASSERT_TRUE(tight_editor.addWord('Z', 0, 3.0, 3));
  EXPECT_EQ(written(tight_editor), "N5G1X1.Z3.F100.");
}

TEST(BlockWriter, AddsWhereNoAxisStands) {
  const auto with = [](std::string_view text) {
    const Block block = blockOf(text);
    BlockEditor editor(block, kStyle);
    EXPECT_TRUE(editor.addWord('X', 0, 1.0, 3));
    return written(editor);
  };
  EXPECT_EQ(with("N10 G01 F5."), "N10 G01 X1. F5.");
  EXPECT_EQ(with("M8 (on)"), "X1. M8 (on)");
  EXPECT_EQ(with(""), "X1.");
  EXPECT_EQ(with("/M8"), "/X1. M8");
}

TEST(BlockWriter, SiemensForms) {
  const Block block = blockOf("G1 X=10.5 C2=12.5 ; x", Dialect::Siemens);
  BlockEditor editor(block, NumberStyle{3, 3, false, false});
  ASSERT_TRUE(editor.setValue(*block.find('C', 2), 13.0, 3));
  ASSERT_TRUE(editor.setValue(*block.find('X'), 10.0, 3));
  EXPECT_EQ(written(editor), "G1 X=10 C2=13 ; x");
}

TEST(BlockWriter, RemovesAndReplacesWords) {
  const Block block = blockOf("G02 X1. I5. J0 F9.");
  BlockEditor editor(block, kStyle);
  ASSERT_TRUE(editor.replace(*block.find('G'), "G01"));
  ASSERT_TRUE(editor.remove(*block.find('I')));
  ASSERT_TRUE(editor.remove(*block.find('J')));
  EXPECT_EQ(written(editor), "G01 X1. F9.");
  const Block first = blockOf("X1. Y2.");
  BlockEditor first_editor(first, kStyle);
  ASSERT_TRUE(first_editor.remove(first.words[0]));
  EXPECT_EQ(written(first_editor), "Y2.");
}

TEST(BlockWriter, RefusesNonsense) {
  Block block = blockOf("X1.");
  BlockEditor editor(block, kStyle);
  EXPECT_FALSE(editor.setValue(block.words[0], std::numeric_limits<double>::quiet_NaN(), 3));
  EXPECT_FALSE(editor.addWord('Y', 0, std::numeric_limits<double>::infinity(), 3));
  block.words[0].expression = true;
  EXPECT_FALSE(editor.setValue(block.words[0], 1.0, 3));
  EXPECT_EQ(written(editor), "X1.");
}

TEST(BlockWriter, WhatIsWrittenIsReadBackBitEqual) {
  Block block = blockOf("G1 X1.5 Y2. F9.");
  std::string line;
  for (int i = 0; i < 2000; ++i) {
    const double value = -37.123456789 + 0.0371234567 * i;
    BlockEditor editor(block, kStyle);
    ASSERT_TRUE(editor.setValue(*block.find('X'), value, 6));
    line.clear();
    editor.appendTo(line);
    const Block again = blockOf(line);
    ASSERT_EQ(again.find('X')->value, writtenValue(value, 6)) << line;
  }
}

TEST(NumberStyle, IsLearntFromTheProgram) {
  InterpreterOptions options;
  options.axes.count = 2;
  options.axes.axes[0] = {{'X', 0}, false, false};
  options.axes.axes[1] = {{'C', 0}, true, false};
  const auto learn = [&](const std::string& program, Dialect dialect) {
    MemoryText text("t", program);
    return learnNumberStyle(text, dialect, options.axes).value();
  };
  const NumberStyle fanuc = learn("G0 X1.25 C10.\nX3. C.12345\n", Dialect::Fanuc);
  EXPECT_EQ(fanuc.linear_decimals, 2);
  EXPECT_EQ(fanuc.rotary_decimals, 5);
  EXPECT_TRUE(fanuc.keep_point);
  EXPECT_FALSE(fanuc.trailing_zeros);
  const NumberStyle full = learn("G0 X1.250 C10.000\nX3.000\n", Dialect::Fanuc);
  EXPECT_TRUE(full.trailing_zeros);
  const NumberStyle siemens = learn("G0 X1.25\nX3\n", Dialect::Siemens);
  EXPECT_FALSE(siemens.keep_point);
}

}  // namespace
}  // namespace nineline::nc
