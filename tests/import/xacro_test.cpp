// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/xacro.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "torsor/generator/base/error.hpp"
#include "tests/import/xacro_values.hpp"

namespace torsor::xacro_test {
namespace {

const char* const open_robot = "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n";

/// Without line ends and indentation.
std::string without_layout(const std::string& text) {
  std::string plain;
  bool indentation = true;
  for (const char c : text) {
    if (c == '\n')
      indentation = true;
    else if (c != ' ')
      indentation = false;
    if (!indentation) plain += c;
  }
  return plain;
}

/// What a robot's content expands to, without the robot's own tags.
std::string expanded(const std::string& content, const XacroOptions& options = {}) {
  const std::string text = without_layout(expand_xacro(open_robot + content + "</robot>", "r.xacro", options).text);
  const std::string begin = "<robot name=\"r\">", end = "</robot>";
  EXPECT_TRUE(text.starts_with(begin) && text.ends_with(end)) << text;
  return text.substr(begin.size(), text.size() - begin.size() - end.size());
}

using testing_xacro::value_of;

void expect_refused(const std::string& content, const std::string& message, const XacroOptions& options = {}) {
  try {
    expand_xacro(open_robot + content + "</robot>", "r.xacro", options);
    FAIL() << content << " was expanded";
  } catch (const Error& error) {
    EXPECT_EQ(error.what(), message) << content;
  }
}

// What Python 3.11 prints for each: print(expression), and str(expression) inside a text.
TEST(XacroExpression, PrintsWhatPythonPrints) {
  for (const auto& [expression, printed] :
       std::vector<std::pair<std::string, std::string>>{{"1 + 2", "3"},
                                                        {"1 + 2.0", "3.0"},
                                                        {"0.1 + 0.2", "0.30000000000000004"},
                                                        {"1/3", "0.3333333333333333"},
                                                        {"10 / 5", "2.0"},
                                                        {"10 // 3", "3"},
                                                        {"8 - 3 - 2", "3"},
                                                        {"8 - 3 + 2", "7"},
                                                        {"8 / 4 / 2", "1.0"},
                                                        {"-7 // 2", "-4"},
                                                        {"-7 % 3", "2"},
                                                        {"7.5 % -2", "-0.5"},
                                                        {"-7.5 // 2", "-4.0"},
                                                        {"2 ** 10", "1024"},
                                                        {"2 ** -1", "0.5"},
                                                        {"-2 ** 2", "-4"},
                                                        {"2 ** 3 ** 2", "512"},
                                                        {"1e16", "1e+16"},
                                                        {"1e15", "1000000000000000.0"},
                                                        {"1e-4", "0.0001"},
                                                        {"0.00001234", "1.234e-05"},
                                                        {"1.5e300 * 1e10", "inf"},
                                                        {"pi", "3.141592653589793"},
                                                        {"pi/2", "1.5707963267948966"},
                                                        {"sin(0.3)", "0.29552020666133955"},
                                                        {"cos(pi/6)", "0.8660254037844387"},
                                                        {"radians(30)", "0.5235987755982988"},
                                                        {"degrees(1)", "57.29577951308232"},
                                                        {"sqrt(2)", "1.4142135623730951"},
                                                        {"atan2(1, -1)", "2.356194490192345"},
                                                        {"abs(-3)", "3"},
                                                        {"abs(-3.5)", "3.5"},
                                                        {"min(2, 1.5, 7)", "1.5"},
                                                        {"max([1, 9, 3])", "9"},
                                                        {"round(2.5)", "2"},
                                                        {"round(2.675, 2)", "2.67"},
                                                        {"int(-3.7)", "-3"},
                                                        {"float('1.50')", "1.5"},
                                                        {"floor(-0.5)", "-1"},
                                                        {"1 if 2 &gt; 1 else 0", "1"},
                                                        {"1 &lt; 2 &lt; 3", "True"},
                                                        {"1 &lt; 3 &lt; 2", "False"},
                                                        {"not 1 == 2 and True", "True"},
                                                        {"0 or 5", "5"},
                                                        {"2 and 3", "3"},
                                                        {"True + 1", "2"},
                                                        {"'a' + str(1)", "a1"},
                                                        {"'ab' * 2", "abab"},
                                                        {"'b' in 'abc'", "True"},
                                                        {"3 not in [1, 2]", "True"},
                                                        {"[1, 2.0, 'x']", "[1, 2.0, 'x']"},
                                                        {"[x * x for x in range(5) if x % 2]", "[1, 9]"},
                                                        {"{'a': [1, 2]}['a'][-1]", "2"},
                                                        {"dict(k=4).k", "4"},
                                                        {"[1, 2, 3, 4][1:-1]", "[2, 3]"},
                                                        {"'left_arm'.split('_')[1].upper()", "ARM"},
                                                        {"len('four')", "4"},
                                                        {"(1, 2)", "(1, 2)"},
                                                        {"1_000", "1000"},
                                                        {"math.pi", "3.141592653589793"},
                                                        {"None", "None"},
                                                        {"123456789.0 * 1e8", "1.23456789e+16"},
                                                        {"5e-324", "5e-324"},
                                                        {"-0.0", "-0.0"},
                                                        {"3 * 1e-5", "3.0000000000000004e-05"}}) {
    EXPECT_EQ(value_of(expression), printed) << expression;
  }
}

// What Python 3.11 prints for each.
TEST(XacroExpression, WritesValuesByAFormat) {
  for (const auto& [expression, printed] : std::vector<std::pair<std::string, std::string>>{
           {"'%d' % 7", "7"},
           {"'joint_%d' % 3.7", "joint_3"},
           {"'%d' % -3.7", "-3"},
           {"'%s_%d' % ('arm', 2)", "arm_2"},
           {"'%02d' % 5", "05"},
           {"'%5d|' % 42", "   42|"},
           {"'%-5d|' % 42", "42   |"},
           {"'%+d' % 3", "+3"},
           {"'% d' % 3", " 3"},
           {"'%i%%' % 90", "90%"},
           {"'%.3f' % (1.0 / 3)", "0.333"},
           {"'%8.2f|' % -1.5", "   -1.50|"},
           {"'%08.3f' % -1.5", "-001.500"},
           {"'%+.2e' % 12345.678", "+1.23e+04"},
           {"'%g' % 0.0001", "0.0001"},
           {"'%g' % 1e20", "1e+20"},
           {"'%G' % 1e-7", "1E-07"},
           {"'%.3g' % 1234.5", "1.23e+03"},
           {"'%s' % 2.0", "2.0"},
           {"'%s' % [1, 'a']", "[1, 'a']"},
           {"'%r' % 'a'", "'a'"},
           {"'%10s|' % 'arm'", "       arm|"},
           {"'%-10s|' % 'arm'", "arm       |"},
           {"'%.2s' % 'left'", "le"},
           {"'%.2s|' % 'bébé'", "bé|"},
           {"'%(side)s_%(n)02d' % {'side': 'left', 'n': 4}", "left_04"},
           {"'%s' % True", "True"},
           {"'%d' % True", "1"},
           {"'%f' % 3", "3.000000"},
           {"'%#.0f' % 2", "2."},
           {"'%s%s' % (1, 2)", "12"},
           {"'%%' % ()", "%"},
           {"'%05d' % -42", "-0042"},
           {"'%-05d|' % 3", "3    |"},
           {"'%.0f' % 2.5", "2"},
           {"'%u' % 12", "12"},
           {"'%e' % 0", "0.000000e+00"}}) {
    EXPECT_EQ(value_of(expression), printed) << expression;
  }
  const auto refused = [](const std::string& expression, const std::string& message) {
    expect_refused("<a v=\"${" + expression + "}\"/>", "r.xacro:2: <a>: ${" + expression + "}: the format " + message);
  };
  refused("'%d %d' % 1", "'%d %d' has more conversions than the value given");
  refused("'%d' % (1, 2)", "'%d' has fewer conversions than values: 1 of 2");
  refused("'arm' % 1", "'arm' has fewer conversions than values: 0 of 1");
  refused("'%' % 1", "'%' ends within a conversion");
  refused("'%x' % 1", "'%x' has a conversion that is not read here; there are %d, %i, %u, %e, %f, %g, %s, %r and %%");
  refused("'%(a)d' % 1", "'%(a)d' has names: give a dictionary");
  refused("'%99999d' % 1", "'%99999d' has a number above 1000");
  refused("'%d' % 1e30", "'%d' has an integer beyond 64 bits");
}

TEST(XacroExpression, SaysWhatIsWrong) {
  const auto refused = [](const std::string& expression, const std::string& message) {
    expect_refused("<a v=\"${" + expression + "}\"/>", "r.xacro:2: <a>: ${" + expression + "}: " + message);
  };
  refused("1 +", "the expression ends too early");
  refused("(1", "')' is missing at the end");
  refused("1 2", "'2' is not expected there");
  refused("lenght * 2",
          "unknown name 'lenght'; define it by <xacro:property name=\"lenght\" value=\"...\"/> or as a parameter of "
          "the macro");
  refused("1 / 0", "1 / 0 divides by zero");
  refused("'a' + 1", "'a' + 1: str and int do not go together; str(...) makes a text of a number");
  refused("sqrt(-1)", "sqrt(-1) is no finite number");
  refused("sin()", "sin takes 1 argument and got 0");
  refused("[1, 2][2]", "index 2 of [1, 2], which has 2");
  refused("{'a': 1}['b']", "there is no 'b'; the keys are 'a'");
  refused("9223372036854775807 + 1", "9223372036854775807 + 1 is an integer beyond 64 bits; write one as a decimal");
  refused("f(1)",
          "unknown function 'f'; there are those of Python's math, abs, min, max, round, len, range, int, float, str, "
          "list, dict, load_yaml");
  refused("1 $ 2", "the character '$' has no meaning in an expression");
  expect_refused("<a v=\"${1\"/>", "r.xacro:2: <a>: '${1' is not closed; end it with '}'");
  const std::string deep(300, '(');
  EXPECT_THROW(value_of(deep + "1" + std::string(300, ')')), FileError);
}

TEST(Xacro, PropertyMayNeedALaterOne) {
  EXPECT_EQ(expanded("<xacro:property name=\"a\" value=\"${b * 2}\"/><xacro:property name=\"b\" value=\"1.50\"/>"
                     "<x v=\"${a} ${b} $${b} $5\" w=\"${b}${b}\"/>"),
            "<x v=\"3.0 1.5 ${b} $5\" w=\"1.51.5\"/>");
}

TEST(Xacro, PropertyMayHaveADefaultBeRemovedAndReachOut) {
  EXPECT_EQ(
      expanded("<xacro:property name=\"a\" value=\"1\"/><xacro:property name=\"a\" default=\"2\"/>"
               "<xacro:property name=\"b\" default=\"3\"/><x v=\"${a} ${b}\"/>"
               "<xacro:property name=\"a\" remove=\"true\"/><xacro:property name=\"a\" default=\"4\"/><x v=\"${a}\"/>"),
      "<x v=\"1 3\"/><x v=\"4\"/>");
  EXPECT_EQ(expanded("<xacro:macro name=\"m\" params=\"v\"><xacro:property name=\"here\" value=\"${v}\"/>"
                     "<xacro:property name=\"out\" value=\"${v + here}\" scope=\"parent\"/>"
                     "<xacro:n v=\"${v}\"/></xacro:macro>"
                     "<xacro:macro name=\"n\" params=\"v\"><xacro:property name=\"everywhere\" value=\"${v * 10}\" "
                     "scope=\"global\"/>"
                     "</xacro:macro><xacro:property name=\"here\" value=\"7\"/><xacro:m v=\"2\"/>"
                     "<x v=\"${out} ${everywhere} ${here}\"/>"),
            "<x v=\"4 20 7\"/>");
}

TEST(Xacro, MacroTakesParametersDefaultsForwardsAndBlocks) {
  EXPECT_EQ(expanded("<xacro:property name=\"prefix\" value=\"left_\"/>"
                     "<xacro:macro name=\"m\" params=\"name size:=2 text:='a b' prefix:=^ side:=^|near *tip **more\">"
                     "<l n=\"${prefix}${name} ${size} ${text} ${side}\"><xacro:insert_block name=\"tip\"/>"
                     "<xacro:insert_block name=\"more\"/></l></xacro:macro>"
                     "<xacro:m name=\"arm\" size=\"${1+2}\"><t v=\"${prefix}\"/><two><p/><q/></two></xacro:m>"),
            "<l n=\"left_arm 3 a b near\"><t v=\"left_\"/><p/><q/></l>");
}

// As xacro reads params: one expression goes to the first bracket that ends a word; otherwise both quotes hold blanks.
TEST(Xacro, DefaultsOfParametersMayHoldBlanks) {
  const std::string properties = "<xacro:property name=\"a\" value=\"2\"/><xacro:property name=\"b\" value=\"3\"/>";
  const auto with = [&properties](const std::string& parameters) {
    return expanded(properties + "<xacro:macro name=\"m\" params='" + parameters +
                    "'><x v=\"${m}|${n}\"/></xacro:macro><xacro:m/>");
  };
  EXPECT_EQ(with("m:=${a + b} n:=7"), "<x v=\"5|7\"/>");
  EXPECT_EQ(with("m:=^|${ a*{1: 4}[1] } n=$(eval 1 + 1)"), "<x v=\"8|2\"/>");
  EXPECT_EQ(with("m:=${a}${b} n:=x${a}"), "<x v=\"23|x2\"/>");
  EXPECT_EQ(with("m:=\"p q\" n:=\"it&apos;s\""), "<x v=\"&quot;p q&quot;|&quot;it's&quot;\"/>");
}

// int("1_2") is 12 in Python; xacro keeps the text of a property, and an expression has Python's number.
TEST(Xacro, ATextWithAnUnderscoreStaysAText) {
  EXPECT_EQ(expanded("<xacro:property name=\"id\" value=\"1_2\"/><xacro:property name=\"n\" value=\"${1_000}\"/>"
                     "<xacro:macro name=\"m\" params=\"i j:=3_4\"><y v=\"${i}${j}\"/></xacro:macro>"
                     "<x v=\"link${id} ${n}\"/><xacro:m i=\"5_6\"/>"),
            "<x v=\"link1_2 1000\"/><y v=\"5_63_4\"/>");
}

// A lazy property is evaluated where it is used first, another one where it stands.
TEST(Xacro, PropertyMayBeEvaluatedAtOnce) {
  const auto with = [](const std::string& lazy) {
    return expanded("<xacro:property name=\"a\" value=\"1\"/><xacro:property name=\"b\" value=\"${a + 1}\" " + lazy +
                    "/><xacro:property name=\"a\" value=\"10\"/><x v=\"${b}\"/>");
  };
  EXPECT_EQ(with(""), "<x v=\"11\"/>");
  EXPECT_EQ(with("lazy_eval=\"true\""), "<x v=\"11\"/>");
  EXPECT_EQ(with("lazy_eval=\"false\""), "<x v=\"2\"/>");
  EXPECT_EQ(with("lazy_eval=\"${1 == 2}\""), "<x v=\"2\"/>");
  expect_refused("<xacro:property name=\"b\" value=\"1\" lazy_eval=\"perhaps\"/>",
                 "r.xacro:2: <xacro:property name=\"b\">: the condition is \"perhaps\"; write true, false, an integer or an "
                 "expression ${...}");
}

TEST(Xacro, MacroMayCallItselfWhileACondition) {
  EXPECT_EQ(
      expanded("<xacro:macro name=\"m\" params=\"i\"><xacro:if value=\"${i}\"><x i=\"${i}\"/><xacro:m i=\"${i - 1}\"/>"
               "</xacro:if></xacro:macro><xacro:m i=\"3\"/><xacro:call macro=\"${'m'}\" i=\"1\"/>"),
      "<x i=\"3\"/><x i=\"2\"/><x i=\"1\"/><x i=\"1\"/>");
}

TEST(Xacro, BlocksOfPropertiesConditionsElementsAndAttributes) {
  EXPECT_EQ(
      expanded("<xacro:property name=\"o\"><origin xyz=\"0 0 ${h}\"/><axis/></xacro:property>"
               "<xacro:property name=\"h\" value=\"0.5\"/><j><xacro:insert_block name=\"o\"/></j>"
               "<xacro:if value=\"false\"><no/></xacro:if><xacro:unless value=\"${0}\"><yes/></xacro:unless>"
               "<xacro:element xacro:name=\"${'li' + 'nk'}\" name=\"a\"><xacro:attribute name=\"t\" value=\"${h}\"/>"
               "</xacro:element>"),
      "<j><origin xyz=\"0 0 0.5\"/><axis/></j><yes/><link name=\"a\" t=\"0.5\"/>");
}

TEST(Xacro, ArgumentsComeFromTheCommandLineOrTheirDefault) {
  const std::string file =
      "<xacro:arg name=\"n\" default=\"2\"/><xacro:arg name=\"on\" default=\"true\"/>"
      "<x v=\"$(arg n) ${$(arg n) * 2} $(eval arg('n') + 1)\"/><xacro:if value=\"$(arg on)\"><y/></xacro:if>";
  EXPECT_EQ(expanded(file), "<x v=\"2 4 3\"/><y/>");
  EXPECT_EQ(expanded(file, {{{"n", "5"}, {"on", "false"}}, {}}), "<x v=\"5 10 6\"/>");
  expect_refused(file, "--arg no: the file declares n, on", {{{"no", "5"}}, {}});
}

TEST(Xacro, NamesWhatIsWrongAndTheMacroThatMadeIt) {
  const std::string macro = "<xacro:macro name=\"arm\" params=\"length\">\n<link name=\"${nam}\"/></xacro:macro>\n";
  expect_refused(
      macro + "<xacro:arm length=\"1\"/>",
      "r.xacro:3: <link name=\"${nam}\">: ${nam}: unknown name 'nam'; define it by <xacro:property name=\"nam\" "
      "value=\"...\"/> or as a parameter of the macro (in the macro 'arm', called at r.xacro:4)");
  expect_refused(
      macro + "<xacro:arn length=\"1\"/>",
      "r.xacro:4: <xacro:arn>: there is no macro 'arn'; did you mean 'arm' or 'arg'? define it by <xacro:macro "
      "name=\"arn\"> or include the file that does");
  expect_refused(
      macro + "<xacro:arm lenght=\"1\"/>",
      "r.xacro:4: <xacro:arm>: the macro 'arm' has no parameter 'lenght'; did you mean 'length'? it has length");
  expect_refused(macro + "<xacro:arm/>",
                 "r.xacro:4: <xacro:arm>: the macro 'arm' needs the parameter 'length'; add length=\"...\"");
  expect_refused(macro + "<xacro:arm length=\"1\"><b/></xacro:arm>",
                 "r.xacro:4: <xacro:arm>: the macro 'arm' takes 0 blocks and got 1: <b> is one more; remove it");
  expect_refused("<xacro:macro name=\"m\" params=\"*b\"/><xacro:m/>",
                 "r.xacro:2: <xacro:m>: the block '*b' of the macro 'm' is missing; put an element inside");
  expect_refused(
      "<xacro:if value=\"maybe\"/>",
      "r.xacro:2: <xacro:if>: the condition is \"maybe\"; write true, false, an integer or an expression ${...}");
  expect_refused(
      "<xacro:property name=\"a\" value=\"${b}\"/><xacro:property name=\"b\" value=\"${a}\"/><x v=\"${a}\"/>",
      "r.xacro:2: <x>: ${a}: the property 'a' needs itself: ${b}; give it another value");
  expect_refused("<a v=\"$(arg x)\"/>",
                 "r.xacro:2: <a>: the argument 'x' has no value; declare it by <xacro:arg name=\"x\" "
                 "default=\"...\"/> or give --arg x:=...");
}

TEST(Xacro, EndsWhereMacrosDoNot) {
  const std::string endless = "<xacro:macro name=\"m\" params=\"\"><xacro:m/></xacro:macro><xacro:m/>";
  try {
    expanded(endless);
    FAIL();
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("without end"), std::string::npos) << error.what();
  }
  // Doubling in every call: 2^30 elements.
  std::string doubling;
  for (int i = 0; i < 30; ++i) {
    doubling += "<xacro:macro name=\"m" + std::to_string(i) + "\"><xacro:m" + std::to_string(i + 1) + "/><xacro:m" +
                std::to_string(i + 1) + "/></xacro:macro>";
  }
  EXPECT_THROW(expanded(doubling + "<xacro:macro name=\"m30\"><x/></xacro:macro><xacro:m0/>"), FileError);
}

TEST(Xacro, RefusesTextsAndListsThatGrowWithoutEnd) {
  for (const char* twice : {"${%s + %s}", "${%s}${%s}"}) {
    std::string file = "<xacro:property name=\"p0\" value=\"abcdefgh\"/>";
    for (int i = 0; i < 60; ++i) {
      std::string value = twice;
      for (int n = 0; n < 2; ++n) value.replace(value.find("%s"), 2, "p" + std::to_string(i));
      file += "<xacro:property name=\"p" + std::to_string(i + 1) + "\" value=\"" + value + "\"/>";
    }
    EXPECT_THROW(expanded(file + "<x v=\"${p60}\"/>"), FileError) << twice;
  }
  EXPECT_THROW(value_of("[[x for y in range(100000)] for x in range(100000)]"), FileError);
  EXPECT_THROW(value_of("'a' * 100000 * 100000"), FileError);
}

TEST(Xacro, WhatHoldsNoMechanicsMayNameMissingPackages) {
  EXPECT_EQ(expanded("<link name=\"a\"><visual><mesh filename=\"package://$(find nowhere)/a.stl\"/></visual></link>"),
            "<link name=\"a\"><visual><mesh filename=\"package://$(find nowhere)/a.stl\"/></visual></link>");
}

class XacroFiles : public testing::Test {
 protected:
  XacroFiles() : folder_(std::filesystem::path(testing::TempDir()) / ("xacro_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_ / "my_arm" / "urdf" / "inc");
    std::filesystem::create_directories(folder_ / "elsewhere" / "other");
  }
  ~XacroFiles() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  ExpandedXacro expand(const std::string& content, const XacroOptions& options = {}) const {
    return expand_xacro(open_robot + content + "</robot>", path("my_arm/urdf/r.xacro"), options);
  }
  std::filesystem::path folder_;
};

TEST_F(XacroFiles, AreIncludedByRelativeNamesPackagesAndNamespaces) {
  write("my_arm/urdf/inc/a.xacro", std::string(open_robot) +
                                       "<xacro:property name=\"a\" value=\"1\"/>"
                                       "<xacro:macro name=\"m\" params=\"\"><m "
                                       "v=\"${a}\"/></xacro:macro><xacro:include filename=\"b.xacro\"/></robot>");
  write("my_arm/urdf/inc/b.xacro", std::string(open_robot) + "<b/></robot>");
  write("my_arm/package.xml", "<package><name> arm_description </name></package>");
  write("elsewhere/other/c.xacro", std::string(open_robot) +
                                       "<xacro:property name=\"a\" value=\"2\"/>"
                                       "<xacro:macro name=\"m\" params=\"\"><n v=\"${a}\"/></xacro:macro></robot>");
  const ExpandedXacro result = expand(
      "<xacro:include filename=\"$(find arm_description)/urdf/inc/a.xacro\"/>"
      "<xacro:include filename=\"$(find other)/c.xacro\" ns=\"c\"/><xacro:m/><xacro:c.m/>"
      "<x v=\"${a} ${c.a}\"/>",
      {{}, {path("elsewhere")}});
  EXPECT_EQ(without_layout(result.text), "<robot name=\"r\"><b/><m v=\"1\"/><n v=\"2\"/><x v=\"1 2\"/></robot>");
  EXPECT_EQ(result.files, (std::vector<std::string>{path("my_arm/urdf/inc/a.xacro"), path("my_arm/urdf/inc/b.xacro"),
                                                    path("elsewhere/other/c.xacro")}));
  ASSERT_GE(result.lines.size(), 3U);
  EXPECT_EQ(result.lines[1].file, path("my_arm/urdf/inc/b.xacro"));
  EXPECT_EQ(result.lines[2].within, "in the macro 'm', called at " + path("my_arm/urdf/r.xacro") + ":2");
}

TEST_F(XacroFiles, OfAMacroAreBesideTheFileThatCallsIt) {
  write("my_arm/urdf/inc/m.xacro", std::string(open_robot) +
                                       "<xacro:macro name=\"l\"><x v=\"${load_yaml('p.yaml')['M']}\" "
                                       "d=\"$(dirname)\"/></xacro:macro></robot>");
  write("my_arm/urdf/inc/p.yaml", "M: 2.5\n");
  const std::string file = "<xacro:include filename=\"inc/m.xacro\"/><xacro:l/>";
  const ExpandedXacro beside_macro = expand(file);
  EXPECT_EQ(without_layout(beside_macro.text), "<robot name=\"r\"><x v=\"2.5\" d=\"" + path("my_arm/urdf") + "\"/></robot>");
  EXPECT_EQ(beside_macro.notes, std::vector<std::string>{"xacro: '" + path("my_arm/urdf/inc/p.yaml") +
                                                         "' is read from beside the macro that names it; xacro looks for '" +
                                                         path("my_arm/urdf/p.yaml") + "' only"});
  write("my_arm/urdf/p.yaml", "M: 1.5\n");
  const ExpandedXacro both = expand(file);
  EXPECT_EQ(without_layout(both.text), "<robot name=\"r\"><x v=\"1.5\" d=\"" + path("my_arm/urdf") + "\"/></robot>");
  ASSERT_EQ(both.notes.size(), 1U);
  EXPECT_NE(both.notes[0].find("p.yaml' is read, as xacro reads it, and not '"), std::string::npos) << both.notes[0];
  write("my_arm/urdf/inc/n.xacro", std::string(open_robot) + "<x v=\"${load_yaml('p.yaml')['M']}\"/></robot>");
  const ExpandedXacro included = expand("<xacro:include filename=\"inc/n.xacro\"/>");
  EXPECT_EQ(without_layout(included.text), "<robot name=\"r\"><x v=\"2.5\"/></robot>") << "its own folder is the file's";
  EXPECT_TRUE(included.notes.empty());
}

TEST_F(XacroFiles, ThatIncludeOneAnotherAreRefused) {
  write("my_arm/urdf/inc/a.xacro", std::string(open_robot) + "<xacro:include filename=\"b.xacro\"/></robot>");
  write("my_arm/urdf/inc/b.xacro", std::string(open_robot) + "<xacro:include filename=\"a.xacro\"/></robot>");
  try {
    expand("<xacro:include filename=\"inc/a.xacro\"/>");
    FAIL();
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("b.xacro:2: <xacro:include>: the files include one another in a circle"),
              std::string::npos)
        << error.what();
  }
  EXPECT_THROW(expand("<xacro:include filename=\"none.xacro\"/>"), FileError);
  EXPECT_THROW(expand("<xacro:include filename=\"$(find none)/a.xacro\"/>"), FileError);
}

// What PyYAML, which xacro reads with, makes of these words: numbers with other bases, or texts.
TEST_F(XacroFiles, HoldNumbersOfYaml) {
  const auto twice = [this](const std::string& word) {
    write("my_arm/urdf/n.yaml", "k: " + word + "\n");
    const std::string text = without_layout(expand("<x v=\"${load_yaml('n.yaml')['k'] * 2}\"/>").text);
    const std::size_t begin = text.find("v=\"") + 3;
    return text.substr(begin, text.find('"', begin) - begin);
  };
  const std::vector<std::pair<std::string, std::string>> words{
      {"12", "24"},     {"-7", "-14"},   {"+5", "10"},     {"0", "0"},       {"010", "16"},     {"-017", "-30"},
      {"0x1F", "62"},   {"0b101", "10"}, {"1_000", "2000"}, {"1:30", "180"},  {"2:00:01", "14402"}, {"08", "0808"},
      {"0o17", "0o170o17"}, {"1:60", "1:601:60"}, {"0:30", "0:300:30"}, {"0x", "0x0x"}, {"1e3", "1e31e3"}, {"1.0e+3", "2000.0"},
      {".Inf", "inf"},  {"-.inf", "-inf"},
      {"1:30.5", "181.0"}, {"-1:30.25", "-180.5"}, {"190:20:30.15", "1370460.3"}, {"0:30.5", "61.0"}, {"1:30.", "180.0"},
      {"1_0:5.5", "1211.0"}, {"+1:30._5", "181.0"}, {"1:60.5", "1:60.51:60.5"}, {"1:005.5", "1:005.51:005.5"},
      {"1:3_0", "1:3_01:3_0"}, {"1:30.5e+3", "1:30.5e+31:30.5e+3"}};
  for (const auto& [word, expected] : words) EXPECT_EQ(twice(word), expected) << word;
  EXPECT_EQ(twice(".nan"), "nan");
  EXPECT_EQ(twice("\"a\\\\b\""), "a\\ba\\b");
  EXPECT_THROW(twice("\"\\x33\""), FileError);  // '3' there; here it would be another text
}

// PyYAML keeps the last one: one of the two was not meant.
TEST_F(XacroFiles, RefuseAKeyTwiceInYaml) {
  for (const char* text : {"a: {m: 1, m: 2}\n", "a:\n  m: 1\n  m: 2\n", "a: {b: {m: 1, 'm': 2}}\n"}) {
    write("my_arm/urdf/twice.yaml", text);
    try {
      expand("<a v=\"${load_yaml('twice.yaml')['a']}\"/>");
      FAIL() << text;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("the key 'm' was there before; keep one"), std::string::npos) << error.what();
    }
  }
}

TEST_F(XacroFiles, HoldParametersInYaml) {
  write(
      "my_arm/urdf/p.yaml",
      "# of the arm\nmasses: {base: 2.5, link: 1.25}   # kg\noffsets:\n  - [0.1, 0.2,\n     0.3]\n  - name: \"x # y\"\n"
      "    angle: !degrees 45\n    tilt: -1.0e-3\nlimits:\n    joint1:\n        lower: -3.1\n        active: true\n"
      "list:\n- a\n- 'it''s'\nnothing:\n");
  const ExpandedXacro result = expand(
      "<xacro:property name=\"p\" value=\"${load_yaml('p.yaml')}\"/><x v=\"${p['masses']['base']} "
      "${p.offsets[0][2]} ${p['offsets'][1]['name']} ${p['offsets'][1]['angle']} ${p['offsets'][1]['tilt'] * 2} "
      "${p['limits']['joint1']['lower']} ${p.limits.joint1.active} ${p['list']} ${p['nothing']}\"/>");
  EXPECT_EQ(without_layout(result.text),
            "<robot name=\"r\"><x v=\"2.5 0.3 x # y 0.7853981633974483 -0.002 -3.1 True ['a', &quot;it's&quot;] "
            "None\"/></robot>");
  EXPECT_EQ(result.files, std::vector<std::string>{path("my_arm/urdf/p.yaml")});
  write("my_arm/urdf/q.yaml", "a: 1\nb: &anchor 2\n");
  try {
    expand("<x v=\"${load_yaml('q.yaml')}\"/>");
    FAIL();
  } catch (const FileError& error) {
    EXPECT_EQ(error.what(), path("my_arm/urdf/q.yaml") +
                                ":2: 'b: &anchor 2': anchors and texts of several lines are not "
                                "read here; write the value itself");
  }
}

}  // namespace
}  // namespace torsor::xacro_test
