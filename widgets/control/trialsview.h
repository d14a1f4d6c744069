// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "widgets/common/displayunits.h"
#include "widgets/common/theme.h"
#include "widgets/common/trialnotebook.h"
#include "widgets/common/workbench.h"
#include "widgets/control/trialpair.h"

#include <QWidget>

class QScrollArea;
class QStackedWidget;

namespace mb {

class AdvicePanel;
class MetricsPanel;
class ResponsePlot;
class Segmented;
class TrialList;
class TrialsHead;

/// What the experiments on one loop have shown: A and B over each other, their metrics, and the notebook below. Reads the
/// notebook by itself; runs nothing, stages nothing.
class TrialsView : public QWidget {
    Q_OBJECT
public:
    /// What of it is in sight.
    enum class Shown { All, Plot, Metrics, Trials };

    TrialsView(Workbench &workbench, const ThemeSource &theme, QWidget *parent = nullptr);

    /// Whose trials: a unit (Trial::unit), the axis of a board (else 1), a mode. Nothing happens while all stay the same.
    void choose(const Family *family, const std::string &unit, int axis, Mode mode);
    void setUnits(const DisplayUnits &units);
    /// All at once, or one part that takes all the room.
    void setShown(Shown shown);
    /// What is measured so far of a trial that runs: shown as B at once.
    void showMeasured(const tuning::Trial &trial);
    /// It is over, with its samples. Unless somebody has pinned another, what was B becomes A.
    void addFinished(const tuning::Trial &trial);
    void pin(std::int64_t number);
    void select(std::int64_t number);
    /// A and B change places.
    void flip();
    /// B becomes A.
    void pinCurrent();
    void reload();

    [[nodiscard]] const KeptTrial *a() const { return m_pair.a(); }
    [[nodiscard]] const KeptTrial *b() const { return m_pair.b(); }
    [[nodiscard]] ResponsePlot &plot() { return *m_plot; }
    [[nodiscard]] MetricsPanel &metrics() { return *m_metrics; }
    [[nodiscard]] TrialList &list() { return *m_list; }
    [[nodiscard]] AdvicePanel &advice() { return *m_advice; }
    /// A is shown, because its stimulus is that of B.
    [[nodiscard]] bool isComparable() const { return m_pair.isComparable(); }

Q_SIGNALS:
    void useRequested(const mb::KeptTrial &kept);
    /// What an adviser proposes for trial B: parameter keys and numbers.
    void stageRequested(const std::vector<std::pair<std::string, double>> &changes);
    /// A or B is another.
    void changed();

protected:
    void resizeEvent(QResizeEvent *) override { arrange(); }

private:
    void buildSide();
    void buildFoot();
    void arrange();
    void showParts(bool beside);
    void listed(const std::vector<KeptTrial> &trials);
    void fetch(std::int64_t number, bool asA);
    void draw();
    void drawPlot();

    TrialNotebook &m_notebook;
    const ThemeSource &m_theme;
    const Family *m_family = nullptr;
    std::string m_unit;
    int m_axis = 1;
    Mode m_mode = Mode::Off;
    DisplayUnits m_units;
    TrialPair m_pair;
    bool m_beside = true;
    Shown m_shown = Shown::All;
    ResponsePlot *m_plot = nullptr;
    TrialsHead *m_head = nullptr;
    QWidget *m_side = nullptr;
    QScrollArea *m_numbers = nullptr;
    MetricsPanel *m_metrics = nullptr;
    AdvicePanel *m_advice = nullptr;
    QWidget *m_footLine = nullptr;
    Segmented *m_below = nullptr;
    QStackedWidget *m_foot = nullptr;
    TrialList *m_list = nullptr;
};

} // namespace mb
