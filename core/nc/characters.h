#pragma once

#include <array>
#include <cstdint>

namespace nineline::nc {

/// What a character can start in an NC line.
enum class CharacterClass : std::uint8_t {
  Other,
  Blank,
  Letter,
  Semicolon,
  Parenthesis,
  Percent,
  Slash,
  Colon
};

constexpr std::array<CharacterClass, 256> makeCharacterClasses() {
  std::array<CharacterClass, 256> classes{};
  for (std::size_t c = 'A'; c <= 'Z'; ++c) classes[c] = classes[c + 32] = CharacterClass::Letter;
  for (const char c : {' ', '\t', '\0', '\r', '\v', '\f', '\x7f'})
    classes[static_cast<std::uint8_t>(c)] = CharacterClass::Blank;
  classes[';'] = CharacterClass::Semicolon;
  classes['('] = CharacterClass::Parenthesis;
  classes['%'] = CharacterClass::Percent;
  classes['/'] = CharacterClass::Slash;
  classes[':'] = CharacterClass::Colon;
  return classes;
}
inline constexpr std::array<CharacterClass, 256> kCharacterClasses = makeCharacterClasses();

constexpr CharacterClass classOf(char c) { return kCharacterClasses[static_cast<std::uint8_t>(c)]; }
constexpr bool isBlank(char c) { return classOf(c) == CharacterClass::Blank; }
constexpr bool isLetter(char c) { return classOf(c) == CharacterClass::Letter; }
constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
constexpr char upperOf(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; }

}  // namespace nineline::nc
