// SPDX-License-Identifier: MIT
#pragma once
// The last thing that was done or went wrong, in the line below the views and for screen readers.

#include <string>

#include "base/status.h"
#include "ui/host/host.h"

namespace versorium {

class Notices {
  public:
    explicit Notices(Host& host) : host_(host) {}

    // In English, or in the language already where it was put together.
    void say(const std::string& text);
    // Nothing where it is no error.
    void report(const Status& status);
    // The line; empty once it has stood long enough.
    const std::string& shown() const;
    const std::string& last() const { return text_; }

  private:
    static constexpr double kStands = 6;  // seconds
    Host& host_;
    std::string text_;
    double since_ = -100;
};

}  // namespace versorium
