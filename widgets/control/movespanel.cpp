// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/movespanel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/wrappedlabel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>

namespace mb {
namespace {

enum Kind { ToPosition, ByDistance, AtVelocity };

} // namespace

MovesPanel::MovesPanel(Workbench &workbench, Arming &arming, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_arming(arming)
    , m_theme(theme)
    , m_group(workbench, arming)
{
    setObjectName(QStringLiteral("movesPanel"));
    auto *column = layoutIn<QVBoxLayout>(this, theme.theme().u(6));
    column->addWidget(new SectionLabel(tr("Moves together"), this));
    buildKind();
    m_table = new QWidget(this);
    m_grid = layoutIn<QGridLayout>(m_table, theme.theme().u(6));
    m_grid->setColumnStretch(2, 1);
    column->addWidget(m_table);
    m_hint = wrappedLabel({}, TextRole::Caption, Tone::Dim, this);
    column->addWidget(m_hint);
    buildButtons();
    connect(&m_group, &GroupMotion::changed, this, &MovesPanel::showStates);
    connect(&arming, &Arming::changed, this, &MovesPanel::showStates);
}

void MovesPanel::buildKind()
{
    auto *row = new QHBoxLayout;
    row->setSpacing(m_theme.theme().u(8));
    m_kind = new QComboBox(this);
    m_kind->addItems({tr("to a position"), tr("by a distance"), tr("at a velocity")});
    m_kind->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_kind->setAccessibleName(tr("Kind of the moves"));
    m_profiled = new QCheckBox(tr("profiled"), this);
    m_profiled->setAccessibleName(tr("With the stored acceleration and velocity"));
    m_profiled->setToolTip(tr("With the acceleration and velocity that are stored in the device."));
    m_profiled->setChecked(true);
    row->addWidget(m_kind, 1);
    row->addWidget(m_profiled);
    static_cast<QVBoxLayout *>(layout())->addLayout(row);
}

void MovesPanel::buildButtons()
{
    auto *grid = new QGridLayout;
    grid->setSpacing(m_theme.theme().u(6));
    m_prepare = new CommandButton(m_theme, tr("Prepare"), this);
    m_prepare->setToolTip(tr("Switches the motors on where they stand, and gives each its move to keep."));
    m_prepare->setObjectName(QStringLiteral("prepareMoves"));
    m_start = new CommandButton(m_theme, Symbol::Play, tr("Start"), this);
    m_start->setAccessibleName(tr("Start the prepared moves together"));
    m_start->setToolTip(tr("One command on the line starts all prepared moves at the same moment."));
    m_start->setObjectName(QStringLiteral("startMoves"));
    m_hold = new CommandButton(m_theme, tr("Hold"), this);
    m_hold->setAccessibleName(tr("Hold all of them where they are"));
    m_hold->setToolTip(tr("Brakes to a halt and holds the position. The motors stay on; STOP switches them off."));
    m_hold->setObjectName(QStringLiteral("holdMoves"));
    for (CommandButton *button : {m_prepare, m_start, m_hold})
        button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    grid->addWidget(m_prepare, 0, 0);
    grid->addWidget(m_start, 0, 1);
    grid->addWidget(m_hold, 1, 0, 1, 2);
    static_cast<QVBoxLayout *>(layout())->addLayout(grid);
    connect(m_prepare, &QPushButton::clicked, this, &MovesPanel::prepare);
    connect(m_start, &QPushButton::clicked, this, &MovesPanel::startTogether);
    connect(m_hold, &QPushButton::clicked, this, &MovesPanel::hold);
}

void MovesPanel::follow(const DeviceView &lead)
{
    setVisible(serves(*lead.family));
    if (!serves(*lead.family))
        return;
    m_lead = lead.id;
    std::vector<const DeviceView *> devices;
    for (const DeviceView &view : m_workbench.snapshot().devices) {
        if (view.family == lead.family && view.link == lead.link)
            devices.push_back(&view);
    }
    const bool same = std::ranges::equal(
        devices, m_rows, [](const DeviceView *view, const Row &row) { return view->id == row.device; });
    if (!same)
        rebuild(devices);
    showStates();
}

void MovesPanel::rebuild(const std::vector<const DeviceView *> &devices)
{
    for (const Row &row : m_rows) {
        m_entered[row.device] = {row.takesPart->isChecked(), row.target->text()};
        delete row.takesPart;
        delete row.target;
        delete row.state;
    }
    m_rows.clear();
    for (const DeviceView *view : devices) {
        const QString name = QStringLiteral("#%1").arg(view->identity->address);
        const Entered &entered = m_entered[view->id];
        Row row;
        row.device = view->id;
        row.takesPart = new QCheckBox(name, m_table);
        row.takesPart->setChecked(entered.takesPart);
        row.takesPart->setAccessibleName(tr("%1 takes part").arg(titleOf(*view)));
        row.target = new NumberField(entered.target, m_table);
        row.target->setFixedWidth(m_theme.theme().u(104));
        row.target->setAccessibleName(tr("Target of %1").arg(titleOf(*view)));
        row.state = textLabel({}, TextRole::Caption, Tone::Dim, m_table);
        const int line = static_cast<int>(m_rows.size());
        m_grid->addWidget(row.takesPart, line, 0);
        m_grid->addWidget(row.target, line, 1);
        m_grid->addWidget(row.state, line, 2);
        m_rows.push_back(row);
    }
}

void MovesPanel::showStates()
{
    for (const Row &row : m_rows) {
        const DeviceView *view = m_workbench.snapshot().device(row.device);
        QString text;
        Tone tone = Tone::Dim;
        if (!view || !view->liveness.heard) {
            text = tr("no answer");
        } else if (m_group.hasAcknowledged(row.device)) {
            text = m_group.isStarted() ? tr("started") : tr("prepared");
            tone = m_group.isStarted() ? Tone::Text : Tone::Ok;
        } else if (view->motion.running) {
            text = m_group.isActive() && !m_group.isStarted() ? tr("being prepared") : tr("moving");
        } else if (keepsStoppedMove(*view)) {
            text = tr("keeps a move");
            tone = Tone::Caution;
        } else if (!view->mayNotMove.empty()) {
            text = tr("locked");
            tone = Tone::Caution;
        } else {
            text = tr("off");
        }
        row.state->setText(text);
        setTone(*row.state, tone);
    }
    const bool armed = m_arming.isArmed(m_lead);
    m_prepare->setEnabled(armed);
    m_hold->setEnabled(armed && m_arming.isMoving());
    m_start->setEnabled(m_group.isPrepared());
    m_start->setPrimary(m_group.isPrepared());
    m_hint->setText(hint());
}

QString MovesPanel::hint() const
{
    if (m_group.isPrepared())
        return tr("All are prepared. Start begins them at the same moment.");
    QStringList keeping;
    for (const Row &row : m_rows) {
        const DeviceView *view = m_workbench.snapshot().device(row.device);
        if (view && keepsStoppedMove(*view))
            keeping += row.takesPart->text();
    }
    if (!keeping.isEmpty())
        return tr(
            "Stop takes no move away that has not begun: %1 would begin it with the next start on this line. Prepare "
            "gives a new one; switching the unit off clears it.")
            .arg(keeping.join(QStringLiteral(", ")));
    return !m_arming.isArmed(m_lead)
        ? tr("Hold the Arm button. It covers all that take part.")
        : tr("Prepare switches the motors on where they stand; nothing turns before Start.");
}

SetPoint MovesPanel::setPointOf(double target) const
{
    SetPoint setPoint;
    const bool profiled = m_profiled->isChecked();
    if (m_kind->currentIndex() == AtVelocity)
        setPoint.mode = profiled ? Mode::RampVelocity : Mode::Velocity;
    else
        setPoint.mode = profiled ? Mode::RampPosition : Mode::Position;
    setPoint.relative = m_kind->currentIndex() == ByDistance;
    setPoint.target = target;
    return setPoint;
}

std::optional<std::vector<GroupMotion::Member>> MovesPanel::members() const
{
    std::vector<GroupMotion::Member> all;
    for (const Row &row : m_rows) {
        const auto target = parseNumber(row.target->text());
        setStyleProperty(*row.target, "state", target ? QString() : QStringLiteral("error"));
        if (!row.takesPart->isChecked())
            continue;
        if (!target) {
            m_workbench.report(Severity::Caution, row.takesPart->text(),
                tr("not prepared: '%1' is no number of counts").arg(row.target->text()));
            return std::nullopt;
        }
        all.push_back({row.device, setPointOf(*target)});
    }
    return all;
}

void MovesPanel::prepare()
{
    auto all = members();
    if (!all)
        return;
    Q_EMIT taken();
    m_group.prepare(m_lead, std::move(*all));
}

void MovesPanel::hold()
{
    Q_EMIT taken();
    m_group.hold();
}

} // namespace mb
