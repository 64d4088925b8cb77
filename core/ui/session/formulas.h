// SPDX-License-Identifier: MIT
#pragma once
// Formulas of one's own in the studio: what is being typed, and the ones that were saved under a
// name, which the host keeps from one start to the next.

#include <optional>
#include <string>
#include <vector>

#include "maps/formula_map.h"
#include "ui/host/host.h"

namespace versorium {

struct StudioContext;

struct SavedFormula {
    std::string name, text;
};

class SavedFormulas {
  public:
    static constexpr std::size_t kMost = 100;
    static constexpr std::size_t kNameSize = 60;  // bytes

    // Reads what the host kept; what is no formula any more is left out.
    void load(Host& host);
    // Takes the place of one with the same name. ErrorKind::usage where the name is empty or too
    // long, or where there are kMost already.
    Status save(Host& host, const std::string& name, const std::string& text);
    void forget(Host& host, const std::string& name);
    const std::vector<SavedFormula>& all() const { return all_; }

  private:
    void store(Host& host) const;
    std::vector<SavedFormula> all_;
};

// The field in which a formula is typed.
struct FormulaEditor {
    bool open = false;    // also where the map is none
    int focusFrames = 0;  // for which the field asks for the keys: a dialog may still be closing
    std::string text;     // what stands in the field
    std::string shown;    // the formula that it was filled from
    std::string name;     // to save it under
    FormulaFault fault;   // of `text`; without a message where it reads well
};

// Makes the formula the map of the workspace. Views, parameters and colours that fit are kept. The
// same formula changes nothing. ErrorKind::usage where it does not read.
Status applyFormula(StudioContext& context, const std::string& text);
// Opens the field, filled with the present formula or with z^2 + c.
void editFormula(StudioContext& context);

// The formula that a text is; none where it is something else.
std::optional<std::string> formulaIn(const std::string& text);

}  // namespace versorium
