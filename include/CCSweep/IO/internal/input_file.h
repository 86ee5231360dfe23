// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_INTERNAL_INPUT_FILE_H
#define CCSWEEP_IO_INTERNAL_INPUT_FILE_H

#include <CCSweep/internal/guarded.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace CCSweep::internal {

// A file, wholly in memory: readers can then ask how much is left before they believe a count.
struct Input_file {
  std::string path;
  std::string data;

  [[noreturn]] void fail(const std::string& what) const {
    internal::fail(Status_code::unreadable_file, Stage::input, path + ": " + what);
  }
};

inline Input_file load(const std::string& path) {
  Input_file file{path, {}};
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) file.fail("is a folder, not a file");
  std::ifstream in(path, std::ios::binary);
  if (!in) file.fail("can't be opened");
  in.seekg(0, std::ios::end);
  const std::streamoff size = in.tellg();
  if (!in || size < 0) file.fail("can't be read");
  in.seekg(0);
  file.data.resize(static_cast<std::size_t>(size));
  in.read(file.data.data(), size);
  if (!in) file.fail("can't be read to its end");
  return file;
}

inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

// Excerpt of the input for a message: short, and printable whatever the bytes are.
inline std::string excerpt(std::string_view token) {
  std::string result = "'";
  for (char c : token.substr(0, 24)) result += c >= ' ' && c < 127 ? c : '?';
  return result + (token.size() > 24 ? "...'" : "'");
}

inline std::optional<double> to_number(std::string_view token) {
  if (!token.empty() && token.front() == '+') token.remove_prefix(1);
  double value = 0;
  const char* end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
  // Too large or too small for a double: infinity or zero, and infinity is refused later by its own status.
  if (error == std::errc::result_out_of_range) return std::strtod(std::string(token).c_str(), nullptr);
  return value;
}

inline bool is_integer(double value) { return std::isfinite(value) && value == std::floor(value); }

// Walks through a text by lines and blank separated tokens.
class Text_cursor {
 public:
  explicit Text_cursor(const Input_file& file, std::size_t position = 0, std::size_t line = 1)
      : file_(&file), position_(position), line_(line) {}

  std::size_t position() const { return position_; }
  std::size_t line() const { return line_; }
  std::size_t remaining() const { return file_->data.size() - position_; }

  // The next token of this line; empty at its end.
  std::string_view token() {
    const std::string& data = file_->data;
    while (position_ < data.size() && is_blank(data[position_])) ++position_;
    const std::size_t begin = position_;
    while (position_ < data.size() && data[position_] != '\n' && !is_blank(data[position_])) ++position_;
    return std::string_view(data).substr(begin, position_ - begin);
  }

  // The rest of this line without its end; the cursor moves to the next one.
  std::string_view rest_of_line() {
    const std::string_view data = file_->data;
    const std::size_t begin = position_;
    const std::size_t end = std::min(data.find('\n', begin), data.size());
    position_ = std::min(end + 1, data.size());
    ++line_;
    std::string_view rest = data.substr(begin, end - begin);
    while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
    return rest;
  }

  // The next token of any line; empty at the end of the file. With `comment`, text from it to the end of a line is
  // passed over.
  std::string_view token_of_any_line(char comment = '\0') {
    while (true) {
      const std::string_view found = token();
      const bool is_comment = comment != '\0' && !found.empty() && found.front() == comment;
      if (!found.empty() && !is_comment) return found;
      if (found.empty() && remaining() == 0) return found;
      rest_of_line();
    }
  }

  double number(std::string_view token, const char* what) const {
    if (token.empty()) fail(std::string("ends where ") + what + " is expected");
    const auto value = to_number(token);
    if (!value) fail(std::string(what) + " is expected, not " + excerpt(token));
    return *value;
  }

  [[noreturn]] void fail(const std::string& what) const { file_->fail("line " + std::to_string(line_) + ": " + what); }

 private:
  const Input_file* file_;
  std::size_t position_;
  std::size_t line_;
};

}  // namespace CCSweep::internal

#endif
