// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/axestour.h"

#include "widgets/control/axespanel.h"
#include "widgets/control/tuneaxes.h"
#include "widgets/control/tunecolumn.h"
#include "widgets/control/tuneform.h"
#include "widgets/control/tunepage.h"
#include "widgets/plots/plotspage.h"

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr double distance = 1500.0; ///< counts
constexpr std::chrono::milliseconds shortly{1200};

} // namespace

void AxesTour::plan()
{
    planBoard();
    planStep();
}

void AxesTour::planBoard()
{
    m_stage.add(
        "the board",
        [this] {
            m_stage.window().showPage(PageId::Overview);
            if (m_stage.board())
                m_stage.window().selection().select(m_stage.board()->id);
        },
        [this] { return m_stage.board() && m_stage.board()->liveness.heard; });
    m_stage.picture("board", shortly);
    m_stage.act("an axis", [this] {
        m_stage.window().selection().select(m_stage.board()->id, 2);
        m_stage.window().showPage(PageId::Parameters);
    });
    m_stage.picture("board-parameters", shortly);
}

void AxesTour::planStep()
{
    m_stage.act("tune the board", [this] {
        m_stage.window().selection().select(m_stage.board()->id, 1);
        m_stage.window().showPage(PageId::Tune);
    });
    m_stage.arm("arm the board", [this] { return m_stage.board(); });
    m_stage.pause(600ms);
    m_stage.add(
        "step four axes", [this] { step(distance); }, [this] { return allMove(); });
    m_stage.picture("board-tune", 2500ms);
    m_stage.add(
        "plot four axes",
        [this] {
            m_stage.window().selection().select(m_stage.board()->id);
            m_stage.window().showPage(PageId::Plots);
            m_stage.page<PlotsPage>(PageId::Plots).layoutBook().reset();
            step(0.0);
        },
        [this] { return allMove(); });
    m_stage.picture("board-plots", 1500ms);
    m_stage.add(
        "stop the board", [this] { m_stage.stopAll(); }, [this] { return !m_stage.board()->liveness.moving; });
}

void AxesTour::step(double target)
{
    auto &page = m_stage.page<TunePage>(PageId::Tune);
    page.showLive(true);
    page.form().choose(Mode::Position, target);
    Arming &arming = m_stage.window().arming();
    if (!arming.isArmed(m_stage.board()->id)) // a change of the mode disarms, and so does a picture that takes long
        arming.arm(m_stage.board()->id);
    page.column().axesPanel().setTogether({1, 2, 3, 4});
    page.axes().spread();
    page.run();
}

} // namespace mb
