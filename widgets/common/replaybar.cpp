// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/replaybar.h"

#include "widgets/common/calmwheel.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberformat.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QDateTime>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <array>
#include <limits>

namespace mb {
namespace {

constexpr std::array speeds{0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 100.0, 0.0}; // 0: as fast as possible
constexpr Duration oneYear = std::chrono::hours(24 * 365);

/// Steps of the slider are milliseconds, as many as it can have.
int stepsOf(Duration time)
{
    const auto count = std::chrono::duration_cast<std::chrono::milliseconds>(time).count();
    return static_cast<int>(std::clamp<std::int64_t>(count, 0, std::numeric_limits<int>::max()));
}

QString clockOf(Duration time)
{
    const auto tenths = std::chrono::duration_cast<std::chrono::milliseconds>(time).count() / 100;
    return formatClock(tenths / 10) + QStringLiteral(".%1").arg(tenths % 10);
}

} // namespace

ReplayBar::ReplayBar(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("replayBar"));
    setAccessibleName(tr("Recording that is played"));
    auto *row = new QHBoxLayout(this);
    const Theme &look = theme.theme();
    row->setContentsMargins(look.u(12), look.u(4), look.u(12), look.u(4));
    row->setSpacing(look.u(8));
    QLabel *const mark = badge(tr("REPLAY"), Tone::Accent, this);
    mark->setToolTip(tr("Shows what was recorded. Nothing is sent, no motor moves."));
    row->addWidget(mark);
    m_play = new CommandButton(theme, Symbol::Play, tr("Play"), this);
    m_play->setTextVariants({tr("Play"), tr("Pause"), tr("Play again")});
    m_play->setToolTip(tr("Plays the recording from where it stands, or halts it there"));
    row->addWidget(m_play);
    buildSpeeds(*row);
    buildPosition(*row);
    (new CalmWheel(this))->watch(*this);
    hide();
    connect(m_play, &QPushButton::clicked, this, &ReplayBar::playOrPause);
    connect(&workbench, &Workbench::changed, this, &ReplayBar::follow);
}

void ReplayBar::buildSpeeds(QHBoxLayout &row)
{
    m_speed = new QComboBox(this);
    m_speed->setAccessibleName(tr("Speed of the replay"));
    m_speed->setToolTip(tr("How fast the recording is played"));
    for (const double speed : speeds)
        m_speed->addItem(speed > 0.0 ? editText(speed) + QStringLiteral(" ×") : tr("as fast as possible"), speed);
    row.addWidget(m_speed);
    connect(m_speed, qOverload<int>(&QComboBox::activated), this, [this](int index) {
        m_workbench.send(
            orders::SteerReplay{m_link, {m_speed->itemData(index).toDouble(), std::nullopt, std::nullopt}});
    });
}

void ReplayBar::buildPosition(QHBoxLayout &row)
{
    m_position = new QSlider(Qt::Horizontal, this);
    m_position->setAccessibleName(tr("Position in the recording"));
    m_position->setToolTip(tr("Where the recording stands; arrow keys move it by 1 s, Page Up and Page Down by 10 s"));
    m_position->setSingleStep(1000);
    m_position->setPageStep(10000);
    m_time = new QLabel(this);
    m_time->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    m_name = textLabel({}, TextRole::Body, Tone::Dim, this);
    m_name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_name->setTextInteractionFlags(Qt::NoTextInteraction);
    row.addWidget(m_position, 3);
    row.addWidget(m_time);
    row.addWidget(m_name, 1);
    connect(m_position, &QSlider::valueChanged, this, &ReplayBar::sliderMoved);
    connect(m_position, &QSlider::sliderReleased, this, &ReplayBar::seek);
}

const ReplayState *ReplayBar::replay() const
{
    const LinkView *link = m_workbench.snapshot().link(m_link);
    return link && link->replay ? &*link->replay : nullptr;
}

void ReplayBar::setLink(const std::string &link)
{
    if (m_link == link)
        return;
    m_link = link;
    follow();
}

void ReplayBar::follow()
{
    const LinkView *link = m_workbench.snapshot().link(m_link);
    setVisible(link && link->replay);
    if (link && link->replay)
        show(*link, *link->replay);
}

void ReplayBar::show(const LinkView &link, const ReplayState &replay)
{
    const bool known = replay.surveyed >= 1.0 && !link.scanning && link.state == LinkState::Open;
    for (QWidget *control : {static_cast<QWidget *>(m_play), static_cast<QWidget *>(m_position)})
        control->setEnabled(known);
    m_play->setText(replay.running ? tr("Pause") : replay.ended ? tr("Play again") : tr("Play"));
    m_play->setSymbol(replay.running ? Symbol::Pause : Symbol::Play);
    showSpeed(replay.pace);
    const QString name = QString::fromStdString(link.name);
    m_name->setText(known || link.state != LinkState::Open
            ? name
            : tr("%1: looking through it, %2 %").arg(name, formatNumber(replay.surveyed * 100.0)));
    m_name->setToolTip(QString::fromStdString(link.address));
    if (m_position->isSliderDown())
        return; // a hand is on it
    const QSignalBlocker quiet(m_position);
    m_position->setRange(0, stepsOf(replay.length));
    m_position->setValue(stepsOf(replay.position));
    showTime(replay.position, replay);
}

void ReplayBar::showSpeed(double pace)
{
    if (m_speed->view()->isVisible())
        return; // somebody is choosing
    int index = m_speed->findData(pace);
    if (index < 0) {
        m_speed->addItem(editText(pace) + QStringLiteral(" ×"), pace);
        index = m_speed->count() - 1;
    }
    m_speed->setCurrentIndex(index);
}

void ReplayBar::showTime(Duration position, const ReplayState &replay)
{
    const QString length = clockOf(replay.length);
    m_time->setText(tr("%1 of %2").arg(clockOf(position), length));
    m_time->setMinimumWidth(m_time->fontMetrics().horizontalAdvance(tr("%1 of %2").arg(length, length)));
    if (replay.start < oneYear)
        return; // counted from the beginning of the log, not from 1970
    const auto since1970 = std::chrono::duration_cast<std::chrono::milliseconds>(replay.start + position).count();
    m_time->setToolTip(tr("recorded %1").arg(QDateTime::fromMSecsSinceEpoch(since1970).toString(Qt::ISODateWithMs)));
}

void ReplayBar::playOrPause()
{
    const ReplayState *now = replay();
    if (!now)
        return;
    ReplayOrder order;
    order.run = !now->running;
    if (now->ended && !now->running)
        order.position = Duration::zero();
    m_workbench.send(orders::SteerReplay{m_link, order});
}

void ReplayBar::sliderMoved()
{
    if (!m_position->isSliderDown())
        return seek();
    if (const ReplayState *now = replay())
        showTime(std::chrono::milliseconds(m_position->sliderPosition()), *now);
}

/// Once a move is done, not at each place on the way: devices begin anew wherever a replay is taken to.
void ReplayBar::seek()
{
    m_workbench.send(
        orders::SteerReplay{m_link, {std::nullopt, std::chrono::milliseconds(m_position->value()), std::nullopt}});
}

} // namespace mb
