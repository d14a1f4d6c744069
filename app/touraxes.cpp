// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tour.h"

#include "widgets/control/axespanel.h"
#include "widgets/control/tuneaxes.h"
#include "widgets/control/tunecolumn.h"
#include "widgets/control/tuneform.h"
#include "widgets/control/tunepage.h"
#include "widgets/plots/plotspage.h"

#include <algorithm>

namespace mb {
namespace {

constexpr double distance = 1500.0; // counts
constexpr std::chrono::milliseconds shortly{1200};

} // namespace

const DeviceView *Tour::board() const
{
    const auto &devices = m_workbench.snapshot().devices;
    const auto found = std::find_if(
        devices.begin(), devices.end(), [](const DeviceView &d) { return d.family->capabilities.axes > 1; });
    return found == devices.end() ? nullptr : &*found;
}

void Tour::stepAxes(double target)
{
    auto *page = qobject_cast<TunePage *>(m_window.page(PageId::Tune));
    page->showLive(true);
    page->form().choose(Mode::Position, target);
    if (!m_window.arming().isArmed(board()->id)) // a change of the mode disarms, and so does a picture that takes long
        m_window.arming().arm(board()->id);
    page->column().axesPanel().setTogether({1, 2, 3, 4});
    page->axes().spread();
    page->run();
}

/// The board with its axes: parameters of one, and a step of all at the same moment, on the Tune page and in a plot.
void Tour::planAxes()
{
    add(
        QStringLiteral("the board"),
        [this] {
            m_window.showPage(PageId::Overview);
            if (board())
                m_window.selection().select(board()->id);
        },
        [this] { return board() && board()->liveness.heard; });
    pause(shortly);
    picture(QStringLiteral("board"));
    add(
        QStringLiteral("an axis"),
        [this] {
            m_window.selection().select(board()->id, 2);
            m_window.showPage(PageId::Parameters);
        },
        [] { return true; });
    pause(shortly);
    picture(QStringLiteral("board-parameters"));
    add(
        QStringLiteral("arm the board"),
        [this] {
            m_window.selection().select(board()->id, 1);
            m_window.showPage(PageId::Tune);
            m_window.arming().arm(board()->id);
        },
        [this] { return m_window.arming().isArmed(board()->id); });
    pause(std::chrono::milliseconds(600));
    add(
        QStringLiteral("step four axes"), [this] { stepAxes(distance); },
        [this] { return board()->motion.setPoints.size() == 4; });
    pause(std::chrono::milliseconds(2500));
    picture(QStringLiteral("board-tune"));
    add(
        QStringLiteral("plot four axes"),
        [this] {
            m_window.selection().select(board()->id);
            m_window.showPage(PageId::Plots);
            qobject_cast<PlotsPage *>(m_window.page(PageId::Plots))->layoutBook().reset();
            stepAxes(0.0);
        },
        [this] { return board()->motion.setPoints.size() == 4; });
    pause(std::chrono::milliseconds(1500));
    picture(QStringLiteral("board-plots"));
    add(
        QStringLiteral("stop the board"), [this] { m_window.arming().stopAll(tr("tour")); },
        [this] { return !board()->liveness.moving; });
}

} // namespace mb
