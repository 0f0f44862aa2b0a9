// The scene language as written: text to a tree of nodes, before any meaning is given to it.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "number/rational.hpp"
#include "scene/source.hpp"

namespace lamina::scene {

/// `undef`, `true`, `1/3`, `"steel"`, `[1, [2, 3]]`.
struct Value {
  using List = std::vector<Value>;

  std::size_t offset = 0;
  std::variant<std::monostate, bool, number::Rational, std::string, List> content;

  [[nodiscard]] bool undefined() const { return content.index() == 0; }
};

/// `1` or `size = 1`.
struct Argument {
  std::size_t offset = 0;
  std::string name;  ///< empty if it is given by position
  Value value;
};

/// `%name(arguments) { children }`. An assignment in a block, or at top level, is an
/// argument of the node whose block it is: `{ $fn = 9; ... }` is `($fn = 9) { ... }`.
struct Node {
  std::size_t offset = 0;
  std::string name;
  std::string modifiers;  ///< of `%*#!`
  std::vector<Argument> arguments;
  std::vector<Node> children;
  bool ended_by_semicolon = false;

  [[nodiscard]] bool has_modifier(char c) const { return modifiers.find(c) != std::string::npos; }
};

/// Nodes and lists nest no deeper than this.
inline constexpr std::size_t kMaxDepth = 500;

/// Returns the node `root` whose children are the text's nodes. Throws base::InputError.
Node parse_syntax(const Source& source);

}  // namespace lamina::scene
