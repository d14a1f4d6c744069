// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/enterkey.h"
#include "app/focusorder.h"
#include "app/spokennames.h"

class QApplication;

namespace mb {

/// What the program does for those who have no mouse or no screen, in every window of it. Lives with the application.
class Accessibility {
public:
    explicit Accessibility(QApplication &application);

private:
    FocusOrder m_order;
    EnterKey m_enter;
    SpokenNames m_names;
};

} // namespace mb
