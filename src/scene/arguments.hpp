// The arguments of a node, matched to its parameters and checked.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/affine.hpp"
#include "scene/colors.hpp"
#include "scene/facets.hpp"
#include "scene/syntax.hpp"

namespace lamina::scene {

/// The parameters of a kind of node.
struct Signature {
  std::string_view usage;                      ///< how to write it, for messages
  std::vector<std::string_view> positional{};  ///< in the order they are given without names
  std::size_t required = 0;                    ///< so many of them, from the first, must be given
  std::vector<std::string_view> named_only{};
};

/// A node's arguments. A getter returns nothing if its parameter is not given, or `undef`,
/// which no required parameter is. Every failure is a base::InputError that names the
/// node, points at the argument and says how to write it.
class Arguments {
 public:
  /// Every node also takes $fn, $fa and $fs. Keeps references to the source
  /// and the node; what a signature refers to lives for ever.
  Arguments(const Source& source, const Node& node, const Signature& signature);

  [[nodiscard]] bool has(std::string_view parameter) const { return find(parameter) != nullptr; }
  [[nodiscard]] std::optional<number::Rational> number(std::string_view parameter) const;
  /// A number that is not negative.
  [[nodiscard]] std::optional<number::Rational> size(std::string_view parameter) const;
  [[nodiscard]] std::optional<bool> boolean(std::string_view parameter) const;
  [[nodiscard]] std::optional<std::string> text(std::string_view parameter) const;
  /// Three numbers, or two where OpenSCAD has a default for the third.
  [[nodiscard]] std::optional<geometry::ExactPoint> vector(
      std::string_view parameter, const std::optional<number::Rational>& third = {}) const;
  /// A vector, or a number for all three coordinates.
  [[nodiscard]] std::optional<geometry::ExactPoint> vector_or_number(
      std::string_view parameter, const std::optional<number::Rational>& third = {}) const;
  [[nodiscard]] bool is_number(std::string_view parameter) const;
  /// A list of lists of numbers, each of `columns` if they are given.
  [[nodiscard]] std::optional<std::vector<std::vector<number::Rational>>> matrix(
      std::string_view parameter, std::optional<std::size_t> columns = {}) const;
  [[nodiscard]] std::optional<std::vector<number::Rational>> numbers(
      std::string_view parameter) const;
  /// The name of a colour, or three or four numbers from 0 to 1. Nothing also for
  /// [-1, -1, -1, 1], which is how OpenSCAD writes no colour.
  [[nodiscard]] std::optional<Color> color(std::string_view parameter) const;

  /// What is in force inside the node, given what is outside.
  [[nodiscard]] FacetSettings facets(FacetSettings outside) const;

  [[noreturn]] void fail(std::string_view reason) const;
  /// Points at the parameter's argument.
  [[noreturn]] void fail_at(std::string_view parameter, std::string_view reason) const;

 private:
  struct Binding {
    std::string_view parameter;
    const Argument* argument = nullptr;
  };

  [[noreturn]] void fail(std::size_t offset, std::string_view reason) const;
  void bind(std::string_view parameter, const Argument& argument);
  [[nodiscard]] const Value* find(std::string_view parameter) const;
  template <typename Content>
  [[nodiscard]] const Content* find(std::string_view parameter, std::string_view expected) const;
  [[nodiscard]] std::vector<number::Rational> numbers(const Value::List& list,
                                                      std::string_view parameter) const;

  const Source& source_;
  const Node& node_;
  std::string_view usage_;
  std::vector<Binding> bindings_;
};

}  // namespace lamina::scene
