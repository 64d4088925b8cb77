// SPDX-License-Identifier: MIT
#pragma once
// What can go wrong with the outside world: files, user input, cancellation. A programmer's mistake
// is asserted instead. A message says what was wrong, where, and what to do; no exception is used.

#include <cassert>
#include <optional>
#include <string>
#include <utility>

namespace versorium {

enum class ErrorKind {
    none,
    usage,        // the request itself makes no sense: unknown name, value out of range
    data,         // a file or text was read, and what it holds is wrong
    inputOutput,  // a file could not be opened, read or written
    cancelled,    // the user stopped the work
};

// Success, or the kind of a failure with a message for the user. Immutable value.
class [[nodiscard]] Status {
  public:
    Status() = default;
    Status(ErrorKind kind, std::string message) : kind_(kind), message_(std::move(message)) {
        assert(kind != ErrorKind::none);
    }

    static Status usage(std::string message) { return {ErrorKind::usage, std::move(message)}; }
    static Status data(std::string message) { return {ErrorKind::data, std::move(message)}; }
    static Status inputOutput(std::string message) {
        return {ErrorKind::inputOutput, std::move(message)};
    }
    static Status cancelled() { return {ErrorKind::cancelled, "cancelled"}; }

    bool ok() const { return kind_ == ErrorKind::none; }
    ErrorKind kind() const { return kind_; }
    const std::string& message() const { return message_; }

    // The same failure with "where: " in front, for callers that know the file or the key.
    Status in(const std::string& where) const {
        return ok() ? *this : Status{kind_, where + ": " + message_};
    }

  private:
    ErrorKind kind_ = ErrorKind::none;
    std::string message_;
};

// A value of type T, or the Status that says why there is none. Reading the value of a failure is a
// programmer's mistake.
template <class T>
class [[nodiscard]] Expected {
  public:
    Expected(T value) : value_(std::move(value)) {}
    Expected(Status failure) : status_(std::move(failure)) { assert(!status_.ok()); }

    bool ok() const { return value_.has_value(); }
    explicit operator bool() const { return ok(); }
    const Status& status() const { return status_; }

    const T& operator*() const& { return assert(ok()), *value_; }
    T& operator*() & { return assert(ok()), *value_; }
    T&& operator*() && { return assert(ok()), std::move(*value_); }
    const T* operator->() const { return assert(ok()), &*value_; }
    T* operator->() { return assert(ok()), &*value_; }

  private:
    std::optional<T> value_;
    Status status_;
};

}  // namespace versorium
