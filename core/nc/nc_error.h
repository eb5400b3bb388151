#pragma once

/// Codes of the faults that reading and executing a program can find; stable, translations go by them.
namespace nineline::nc::code {

inline constexpr const char* kBadNumber = "nc.BadNumber";              ///< a word needs a number
inline constexpr const char* kBadWord = "nc.BadWord";                  ///< a character that starts no word
inline constexpr const char* kBadExpression = "nc.BadExpression";      ///< an expression that cannot be read
inline constexpr const char* kUnclosedComment = "nc.UnclosedComment";  ///< '(' without ')'
inline constexpr const char* kRepeatedWord = "nc.RepeatedWord";        ///< the same word twice in a block
inline constexpr const char* kLineTooLong = "nc.LineTooLong";
inline constexpr const char* kUnreadable = "nc.Unreadable";    ///< the file cannot be read
inline constexpr const char* kNoSuchAxis = "nc.NoSuchAxis";    ///< the machine lacks the axis
inline constexpr const char* kUnknownCode = "nc.UnknownCode";  ///< could be motion and is not understood
inline constexpr const char* kPassedCode = "nc.PassedCode";    ///< warning: not understood, moves nothing
inline constexpr const char* kCodeConflict =
    "nc.CodeConflict";  ///< two codes of one group, or axis words twice used
inline constexpr const char* kNoMotionMode = "nc.NoMotionMode";  ///< axis words while motion is cancelled
inline constexpr const char* kMissingWord = "nc.MissingWord";    ///< a code lacks a word that it needs
inline constexpr const char* kBadValue = "nc.BadValue";          ///< a value outside what the code allows
inline constexpr const char* kBadArc = "nc.BadArc";              ///< centre, radius and end do not fit
inline constexpr const char* kNotConstant = "nc.NotConstant";    ///< decided at run time
inline constexpr const char* kNoSuchLabel = "nc.NoSuchLabel";    ///< subprogram or jump target missing
inline constexpr const char* kBadFlow = "nc.BadFlow";            ///< END without DO, return outside, …
inline constexpr const char* kEndless = "nc.Endless";            ///< more jumps than any sane program makes
inline constexpr const char* kTooDeep = "nc.TooDeep";            ///< subprograms nested too deep
inline constexpr const char* kStopped = "nc.Stopped";            ///< the program itself raises an alarm
inline constexpr const char* kNoEnd = "nc.NoEnd";                ///< ends inside a subprogram
inline constexpr const char* kAssumed = "nc.Assumed";  ///< warning: a value that the program does not state

}  // namespace nineline::nc::code
