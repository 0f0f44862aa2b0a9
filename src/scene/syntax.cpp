#include "scene/syntax.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tao/pegtl.hpp>
#include <utility>

#include "base/contract.hpp"

namespace lamina::scene {
namespace {

namespace pegtl = tao::pegtl;

// The syntax tree under construction: the nodes and lists that are still open.
struct Construction {
  const Source& source;
  std::vector<Node> nodes{Node{0, "root", "", {}, {}, false}};
  std::vector<Value> lists{};
  std::string modifiers{};
  Argument argument{};

  void check_depth(std::size_t offset) const {
    if (nodes.size() + lists.size() > kMaxDepth) {
      source.fail(offset, fmt::format("nodes and lists nest more than {} deep: flatten the model",
                                      kMaxDepth));
    }
  }

  void add(Value value) {
    if (lists.empty()) {
      argument.value = std::move(value);
    } else {
      std::get<Value::List>(lists.back().content).push_back(std::move(value));
    }
  }

  void end_argument(std::size_t offset) {
    argument.offset = offset;
    nodes.back().arguments.push_back(std::exchange(argument, {}));
  }
};

#define LAMINA_FLATTEN "`openscad -o model.csg model.scad` flattens programs"

namespace grammar {
using namespace pegtl;

// clang-format off
struct unclosed_comment : failure {};
struct line_comment : seq<string<'/', '/'>, until<eolf>> {};
struct block_comment : sor<seq<string<'/', '*'>, until<string<'*', '/'>>>,
                           seq<at<string<'/', '*'>>, must<unclosed_comment>>> {};
struct gap : star<sor<space, line_comment, block_comment>> {};

struct comma : one<','> {};
struct open_parenthesis : one<'('> {};
struct close_parenthesis : one<')'> {};
struct open_bracket : one<'['> {};
struct close_bracket : one<']'> {};
struct open_brace : one<'{'> {};
struct close_brace : one<'}'> {};
struct semicolon : one<';'> {};

// Items with commas between them, and perhaps after the last.
template <typename Item, typename Close>
struct items : opt<not_at<Close>, must<Item>, gap,
                   star<comma, gap, sor<at<Close>, must<Item>>, gap>> {};

struct value;
struct number_sign : one<'+', '-'> {};
struct decimal : seq<sor<seq<plus<digit>, opt<one<'.'>, star<digit>>>,
                         seq<one<'.'>, plus<digit>>>,
                     opt<one<'e', 'E'>, opt<number_sign>, plus<digit>>> {};
struct end_of_number : not_at<sor<identifier_other, one<'.'>>> {};
struct number : seq<opt<number_sign>, decimal, opt<star<blank>, one<'/'>, star<blank>, decimal>> {};
struct word : seq<opt<number_sign>, identifier> {};
struct unclosed_string : failure {};
struct text_character : sor<seq<one<'\\'>, any>,
                            seq<not_at<sor<range<0, 31>, one<'"', '\\'>>>, utf8::any>> {};
struct text : seq<one<'"'>, star<text_character>, one<'"'>> {};
struct list : seq<open_bracket, gap, items<value, close_bracket>, must<close_bracket>> {};
struct value : sor<seq<number, must<end_of_number>>, word, text, list,
                   seq<at<one<'"'>>, must<unclosed_string>>> {};

struct name : seq<opt<one<'$'>>, identifier> {};
struct argument_name : name {};
struct named_value : seq<at<name, gap, one<'='>>, argument_name, gap, one<'='>, gap,
                         must<value>> {};
struct argument : sor<named_value, value> {};
struct assignment : named_value {};

struct modifier : one<'%', '*', '#', '!'> {};
struct node_name : name {};
struct statement;
struct block : seq<open_brace, gap, star<statement, gap>, must<close_brace>> {};
struct end_of_node : semicolon {};
struct body : sor<end_of_node, block, statement> {};
struct node : seq<node_name, gap, must<open_parenthesis>, gap,
                  items<argument, close_parenthesis>, must<close_parenthesis>, gap,
                  must<body>> {};
struct statement : sor<seq<assignment, gap, must<semicolon>>,
                       node,
                       seq<plus<modifier, gap>, must<node>>,
                       semicolon> {};
struct end_of_text : eof {};
struct document : seq<opt<utf8::bom>, gap, star<statement, gap>, must<end_of_text>> {};
// clang-format on
}  // namespace grammar

template <typename Rule>
inline constexpr const char* kMessage = nullptr;
template <>
inline constexpr const char* kMessage<grammar::unclosed_comment> = "this comment has no `*/`";
template <>
inline constexpr const char* kMessage<grammar::unclosed_string> =
    "this string has no `\"` at its end on the same line, or is not UTF-8";
template <>
inline constexpr const char* kMessage<grammar::end_of_number> =
    "the number ends here: write an integer, a decimal such as 0.25 or 2.5e-1, or a fraction "
    "such as 1/4";
template <>
inline constexpr const char* kMessage<grammar::value> =
    "a value is expected: a number, a fraction such as 1/3, true, false, undef, a \"string\" or a "
    "[list]; " LAMINA_FLATTEN;
template <>
inline constexpr const char* kMessage<grammar::argument> = kMessage<grammar::value>;
template <>
inline constexpr const char* kMessage<grammar::close_bracket> =
    "`,` or `]` is expected; " LAMINA_FLATTEN;
template <>
inline constexpr const char* kMessage<grammar::open_parenthesis> =
    "`(` is expected after the name of a node";
template <>
inline constexpr const char* kMessage<grammar::close_parenthesis> =
    "`,` or `)` is expected; " LAMINA_FLATTEN;
template <>
inline constexpr const char* kMessage<grammar::body> =
    "`;`, a child or `{` is expected after the node";
template <>
inline constexpr const char* kMessage<grammar::semicolon> = "`;` is expected; " LAMINA_FLATTEN;
template <>
inline constexpr const char* kMessage<grammar::node> = "a node is expected after the modifier";
template <>
inline constexpr const char* kMessage<grammar::close_brace> = "a node or `}` is expected";
template <>
inline constexpr const char* kMessage<grammar::end_of_text> =
    "a node such as `cube([1, 2, 3]);` is expected";

struct Messages {
  template <typename Rule>
  static constexpr const char* message = kMessage<Rule>;
  // Only what `must` names is an error: elsewhere the next alternative is tried.
  template <typename Rule>
  static constexpr bool raise_on_failure = false;
};
template <typename Rule>
using Control = pegtl::must_if<Messages>::control<Rule>;

std::string without_blanks(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
  return text;
}

std::string unescaped(std::string_view quoted) {
  std::string result;
  for (std::size_t i = 1; i + 1 < quoted.size(); ++i) {
    if (quoted[i] == '\\') {
      ++i;
      result += quoted[i] == 'n' ? '\n' : quoted[i] == 't' ? '\t' : quoted[i];
    } else {
      result += quoted[i];
    }
  }
  return result;
}

bool not_finite(std::string_view word) {
  word.remove_prefix(std::min(word.find_first_not_of("+-"), word.size()));
  return word == "inf" || word == "nan";
}

template <typename Rule>
struct Action {};

template <>
struct Action<grammar::number> {
  template <typename Input>
  static void apply(const Input& in, Construction& built) {
    const std::size_t offset = in.iterator().byte;
    try {
      built.add({offset, number::parse_rational(without_blanks(in.string()))});
    } catch (const base::InputError& error) {
      built.source.fail(offset, error.what());
    }
  }
};

template <>
struct Action<grammar::word> {
  template <typename Input>
  static void apply(const Input& in, Construction& built) {
    const std::size_t offset = in.iterator().byte;
    const std::string_view word = in.string_view();
    if (word == "true" || word == "false") {
      built.add({offset, word == "true"});
    } else if (word == "undef") {
      built.add({offset, std::monostate{}});
    } else if (not_finite(word)) {
      built.source.fail(offset, fmt::format("`{}` is no finite number: write its value", word));
    } else {
      built.source.fail(
          offset, fmt::format("`{}` is no value: write numbers out; {}", word, LAMINA_FLATTEN));
    }
  }
};

template <>
struct Action<grammar::text> {
  template <typename Input>
  static void apply(const Input& in, Construction& built) {
    built.add({in.iterator().byte, unescaped(in.string_view())});
  }
};

template <>
struct Action<grammar::open_bracket> {
  template <typename Input>
  static void apply(const Input& in, Construction& built) {
    built.lists.push_back({in.iterator().byte, Value::List{}});
    built.check_depth(in.iterator().byte);
  }
};

template <>
struct Action<grammar::list> {
  static void apply0(Construction& built) {
    Value list = std::move(built.lists.back());
    built.lists.pop_back();
    built.add(std::move(list));
  }
};

template <>
struct Action<grammar::argument_name> {
  template <typename Input>
  static void apply(const Input& in, Construction& built) {
    built.argument.name = in.string();
  }
};

template <>
struct Action<grammar::argument> {
  template <typename Input>
  static void apply(const Input& in, Construction& built) {
    built.end_argument(in.iterator().byte);
  }
};

template <>
struct Action<grammar::assignment> {
  template <typename Input>
  static void apply(const Input& in, Construction& built) {
    const std::string& name = built.argument.name;
    if (name != "$fn" && name != "$fa" && name != "$fs") {
      built.source.fail(
          in.iterator().byte,
          fmt::format("`{}` cannot be set, only $fn, $fa and $fs; {}", name, LAMINA_FLATTEN));
    }
    built.end_argument(in.iterator().byte);
  }
};

template <>
struct Action<grammar::modifier> {
  template <typename Input>
  static void apply(const Input& in, Construction& built) {
    built.modifiers += in.peek_char();
  }
};

template <>
struct Action<grammar::node_name> {
  template <typename Input>
  static void apply(const Input& in, Construction& built) {
    Node node;
    node.offset = in.iterator().byte;
    node.name = in.string();
    node.modifiers = std::exchange(built.modifiers, {});
    built.nodes.push_back(std::move(node));
    built.check_depth(in.iterator().byte);
  }
};

template <>
struct Action<grammar::end_of_node> {
  static void apply0(Construction& built) { built.nodes.back().ended_by_semicolon = true; }
};

template <>
struct Action<grammar::node> {
  static void apply0(Construction& built) {
    Node node = std::move(built.nodes.back());
    built.nodes.pop_back();
    built.nodes.back().children.push_back(std::move(node));
  }
};

}  // namespace

Node parse_syntax(const Source& source) {
  Construction built{source};
  pegtl::memory_input<> input(source.text().data(), source.text().size(), "");
  try {
    pegtl::parse<grammar::document, Action, Control>(input, built);
  } catch (const pegtl::parse_error& error) {
    const std::size_t offset = error.positions().front().byte;
    std::string message(error.message());
    if (offset >= source.text().size() && built.nodes.size() > 1) {
      const Node& open = built.nodes.back();
      message +=
          fmt::format(": `{}` in line {} is not complete", open.name, source.line_of(open.offset));
    }
    source.fail(offset, message);
  }
  return std::move(built.nodes.front());
}

}  // namespace lamina::scene
