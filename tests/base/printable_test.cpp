// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/printable.hpp"

#include <array>
#include <cstdio>

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/shell_word.hpp"
#include "torsor/generator/emission/cpp_names.hpp"

namespace torsor::printable_test {
namespace {

const std::string lost = "\xEF\xBF\xBD";  // U+FFFD

TEST(Printable, KeepsWhatAReaderSees) {
  for (const std::string text : {"", "arm", "bras \xC3\xA9tendu", "\xE8\x85\x95", "\xF0\x9F\xA6\xBE", "a\\b?\"'"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, ReplacesControlsDirectionsAndWhatIsNoUtf8) {
  EXPECT_EQ(printable("a\tb\nc\rd"), "a b c d");
  EXPECT_EQ(printable("\x1B[31m"), lost + "[31m");
  EXPECT_EQ(printable("a\x7F"), "a" + lost);
  EXPECT_EQ(printable("\xC2\x9B"), lost);                  // U+009B, a control of terminals
  EXPECT_EQ(printable("a\xE2\x80\xAE\x62"), "a" + lost + "b");  // U+202E turns the direction of text
  EXPECT_EQ(printable("\xE2\x81\xA6\xEF\xBB\xBF"), lost + lost);
  EXPECT_EQ(printable("\xFF\xC3"), lost + lost);
  EXPECT_EQ(printable("\xC0\xAF"), lost + lost);              // not the shortest form
  EXPECT_EQ(printable("\xED\xA0\x80"), lost + lost + lost);  // a surrogate
}

// Whatever quotes a file, a name or a command line.
TEST(Printable, ErrorsAreOneLineThatShowsWhatItHolds) {
  const std::string hostile = "a\nb\x1B[2J\xE2\x80\xAE\xFF";
  const std::string shown = "a b" + lost + "[2J" + lost + lost;
  EXPECT_EQ(Error(hostile).what(), shown);
  EXPECT_EQ(SceneError(hostile).what(), shown);
  EXPECT_EQ(UnitError(hostile).what(), shown);
  EXPECT_EQ(UsageError(hostile).what(), shown);
  EXPECT_EQ(FileError(hostile).what(), shown);
}

TEST(Printable, CommentsEndWhereTheirLineEnds) {
  EXPECT_EQ(comment_text("a\nb"), "a b");
  EXPECT_EQ(comment_text("a\\b"), "a\\b");
  EXPECT_EQ(comment_text("a\\"), "a/");
  EXPECT_EQ(comment_text("a\\\\  "), "a//  ");
  EXPECT_EQ(comment_text("what?\?/"), "what? ?/");
  EXPECT_EQ(comment_text("what??\?="), "what?? ?=");
  EXPECT_EQ(comment_text("what??"), "what??");
}

TEST(ShellWord, IsReadBackByAShellAndRunsNothing) {
  const std::vector<std::string> words{"arm.urdf",      "my arm.urdf",  "it's.urdf",      "$(touch /tmp/x).urdf", "`id`.urdf",
                                       "a\nb.urdf",     "a\\b.urdf",    "a\\",            "\"quoted\"",           "?\?/",
                                       "??\?=?",         "a\x1B[0m\x62", "\xE2\x80\xAE.x", "\xFF\x31",             "~/a",
                                       "a;b&c|d>e<f*g", "!x",           "",               "a\n'?\?'\\$x",          "\xC3\xA9",
                                       "a\n\\n\\101"};  // what a shell would take for escapes, were it not escaped
  for (const std::string& word : words) {
    const std::string safe = shell_word(word);
    EXPECT_EQ(printable(safe), safe);
    EXPECT_EQ(comment_text("run " + safe + " --output x.hpp"), "run " + safe + " --output x.hpp");
    // Passed on as the one argument of a command of bash's own.
    const std::string command = "bash -c 'eval \"printf %s \"\"$(cat)\"' <<'END_OF_WORD'\n" + safe + "\nEND_OF_WORD\n";
    FILE* output = ::popen(command.c_str(), "r");
    ASSERT_NE(output, nullptr);
    std::string read;
    std::array<char, 256> buffer{};
    for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), output)) > 0;) read.append(buffer.data(), n);
    ::pclose(output);
    EXPECT_EQ(read, word) << safe;
  }
  EXPECT_EQ(shell_word("arm-2_a.urdf"), "arm-2_a.urdf");
  EXPECT_EQ(shell_word("my arm"), "'my arm'");
}

}  // namespace
}  // namespace torsor::printable_test
