#include <fmt/format.h>

#include <algorithm>

#include "core/base/text.h"
#include "core/measurement/delimited_text.h"
#include "core/measurement/import.h"

namespace nineline::measurement {

namespace {

using Attributes = std::vector<std::pair<std::string, std::string>>;

/// One start tag and the text up to the next tag.
struct Element {
  std::string name;
  Attributes attributes;
  std::string text;
  std::size_t line = 0;

  [[nodiscard]] std::string attribute(std::string_view key) const {
    for (const auto& [name_of, value] : attributes) {
      if (name_of == key) return value;
    }
    return "";
  }
};

std::string unescaped(std::string_view text) {
  constexpr std::pair<std::string_view, char> kEntities[] = {
      {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}};
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto* entity = std::find_if(std::begin(kEntities), std::end(kEntities),
                                      [&](const auto& one) { return text.substr(i).starts_with(one.first); });
    if (entity != std::end(kEntities)) {
      out += entity->second;
      i += entity->first.size();
    } else {
      out += text[i++];
    }
  }
  return out;
}

/// name="value" pairs of a tag's inside.
Attributes attributesOf(std::string_view inside) {
  Attributes attributes;
  std::size_t at = inside.find_first_of(" \t\r\n");
  while (at != std::string_view::npos) {
    const std::size_t equals = inside.find('=', at);
    if (equals == std::string_view::npos) break;
    const std::size_t open = inside.find_first_of("\"'", equals);
    if (open == std::string_view::npos) break;
    const std::size_t close = inside.find(inside[open], open + 1);
    if (close == std::string_view::npos) break;
    attributes.emplace_back(std::string(trimmed(inside.substr(at, equals - at))),
                            unescaped(inside.substr(open + 1, close - open - 1)));
    at = close + 1;
  }
  return attributes;
}

/// Start tags in order; enough of XML for a file of results, whose nesting does not matter.
Result<std::vector<Element>> elementsOf(std::string_view text, const std::string& source) {
  std::vector<Element> elements;
  std::size_t line = 1;
  std::size_t seen = 0;
  std::size_t at = 0;
  while ((at = text.find('<', at)) != std::string_view::npos) {
    line += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(seen),
                                                text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    seen = at;
    const bool comment = text.substr(at).starts_with("<!--");
    const std::size_t end = text.find(comment ? "-->" : ">", at);
    if (end == std::string_view::npos) {
      return badInput("b5r.xml", "A tag is not closed: the file is cut off; export it again.", source, line);
    }
    const std::string_view inside = text.substr(at + 1, end - at - 1);
    at = end + 1;
    if (comment || inside.empty() || inside.front() == '/' || inside.front() == '?' || inside.front() == '!')
      continue;
    Element element;
    element.name = std::string(inside.substr(0, inside.find_first_of(" \t\r\n/")));
    element.attributes = attributesOf(inside);
    element.text = unescaped(trimmed(text.substr(at, text.find('<', at) - at)));
    element.line = line;
    elements.push_back(std::move(element));
  }
  return elements;
}

}  // namespace

Import importB5r(std::string_view bytes, const std::string& source) {
  Import import;
  import.format = "renishaw-b5r";
  const auto refuse = [&import](const Error& error) {
    import.diagnostics.error(error.code, error.text, error.line);
    return import;
  };
  const Result<DecodedText> decoded = decodeText(bytes, source);
  if (!decoded) return refuse(decoded.error());
  const Result<std::vector<Element>> elements = elementsOf(decoded->text, source);
  if (!elements) return refuse(elements.error());
  for (const Element& element : *elements) {
    if (element.name == "FEATURE") {
      const std::optional<double> value = parseNumber(element.text);
      if (element.attribute("NAME").empty()) {
        import.diagnostics.warning("b5r.feature", "A FEATURE has no NAME; it is left out.", element.line);
        continue;
      }
      import.figures.push_back({element.attribute("NAME"), element.text, value, ""});
      if (!element.attribute("DT").empty()) import.figures.back().unit = element.attribute("DT");
      continue;
    }
    for (const auto& [key, value] : element.attributes) {
      if (key == "NAME" || key == "TEST_PLANE") import.head.emplace_back(element.name + "@" + key, value);
    }
    if (!element.text.empty()) import.head.emplace_back(element.name, element.text);
  }
  if (import.figures.empty()) {
    import.diagnostics.error("b5r.feature", "The file holds no FEATURE with a result of a ballbar test.");
  }
  import.diagnostics.warning("b5r.no_trace",
                             "A .b5r holds the figures of the instrument's software, not the trace; for an "
                             "identification export the trace as a table.");
  return import;
}

}  // namespace nineline::measurement
