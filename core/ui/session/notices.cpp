// SPDX-License-Identifier: MIT
#include "ui/session/notices.h"

#include "i18n/language.h"

namespace versorium {

void Notices::say(const std::string& text) {
    text_ = tr(std::string_view(text));
    since_ = host_.now();
    host_.announce(text_);
    host_.wake();
    host_.wakeAfter(kStands);
}

void Notices::report(const Status& status) {
    if (!status.ok()) say(trMessage(status.message()));
}

const std::string& Notices::shown() const {
    static const std::string nothing;
    return host_.now() - since_ < kStands ? text_ : nothing;
}

}  // namespace versorium
