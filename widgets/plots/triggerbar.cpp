// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/triggerbar.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/segmented.h"
#include "widgets/common/wraplayout.h"

#include <QComboBox>
#include <QLineEdit>

#include <algorithm>
#include <array>
#include <cmath>

namespace mb {
namespace {

using TriggerKind = TriggerRule::Kind;
constexpr std::array kinds{
    TriggerKind::Rising, TriggerKind::Falling, TriggerKind::Either, TriggerKind::Above, TriggerKind::Below};
constexpr std::array parts{0.05, 0.2, 0.5, 0.8, 0.95};

} // namespace

TriggerBar::TriggerBar(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setProperty("surface", QStringLiteral("window"));
    auto *row = new WrapLayout(this); // in a narrow window it takes two lines
    const Theme &now = theme.theme();
    row->setContentsMargins(now.u(12), now.u(4), now.u(12), now.u(4));
    row->setSpacing(now.u(8));
    buildChoices();
    buildLevel();
    auto *close = new IconButton(theme, Symbol::Close, tr("Trigger off"), this);
    for (QWidget *part : {static_cast<QWidget *>(m_trace), static_cast<QWidget *>(m_kind)})
        row->addWidget(part);
    row->addWidget(m_level);
    row->addWidget(m_unit);
    row->addWidget(m_before);
    row->addWidget(m_mode);
    auto *again = new IconButton(theme, Symbol::Refresh, tr("Arm again: forgets this event, waits for the next"), this);
    row->addSpring();
    row->addWidget(again);
    row->addWidget(close);
    connect(again, &QToolButton::clicked, this, &TriggerBar::changed);
    connect(close, &QToolButton::clicked, this, &TriggerBar::closed);
}

void TriggerBar::buildChoices()
{
    m_trace = new QComboBox(this);
    m_trace->setAccessibleName(tr("Trace that triggers"));
    m_kind = new QComboBox(this);
    m_kind->addItems({tr("↑ rises through"), tr("↓ falls through"), tr("↕ crosses"), tr("is above"), tr("is below")});
    m_kind->setAccessibleName(tr("Edge or level"));
    m_before = new QComboBox(this);
    for (const double part : parts)
        m_before->addItem(tr("%1 % before").arg(formatNumber(part * 100.0)));
    m_before->setCurrentIndex(1);
    m_before->setAccessibleName(tr("Part of the window before the event"));
    m_mode = new Segmented(tr("What follows an event"), {tr("Normal"), tr("Single")}, this);
    m_mode->setToolTip(tr("Normal shows every event, single stops at the first"));
    for (QComboBox *box : {m_trace, m_kind, m_before}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        connect(box, qOverload<int>(&QComboBox::activated), this, &TriggerBar::changed);
    }
    connect(m_trace, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int place) {
        m_unit->setText(place >= 0 && place < static_cast<int>(m_choices.size())
                ? m_choices[static_cast<std::size_t>(place)].unit
                : QString());
    });
    connect(m_mode, &Segmented::currentChanged, this, &TriggerBar::changed);
}

void TriggerBar::buildLevel()
{
    m_level = new NumberField(QStringLiteral("0"), this);
    m_level->setFixedWidth(m_theme.theme().u(76));
    m_level->setAccessibleName(tr("Level"));
    m_level->setToolTip(tr("The level; the handle ▸ at the left of the plot drags it, too"));
    m_unit = textLabel({}, TextRole::Caption, Tone::Dim, this);
    connect(m_level, &QLineEdit::editingFinished, this, &TriggerBar::levelTyped);
}

void TriggerBar::levelTyped()
{
    setStyleProperty(*m_level, "state", setup() ? QString() : QStringLiteral("error"));
    Q_EMIT changed();
}

bool TriggerBar::setTraces(const std::vector<Choice> &traces)
{
    const int place = m_trace->currentIndex();
    const Signal before = place < 0 ? Signal{} : m_choices.at(static_cast<std::size_t>(place)).signal;
    m_choices = traces;
    const auto kept = std::ranges::find(m_choices, before, &Choice::signal);
    const bool there = kept != m_choices.end();
    const QSignalBlocker quiet(m_trace);
    m_trace->clear();
    for (const Choice &choice : traces)
        m_trace->addItem(choice.name);
    m_trace->setCurrentIndex(there ? static_cast<int>(kept - m_choices.begin()) : traces.empty() ? -1 : 0);
    m_unit->setText(traces.empty() ? QString() : m_choices[static_cast<std::size_t>(m_trace->currentIndex())].unit);
    return there;
}

int TriggerBar::trace() const
{
    const int place = m_trace->currentIndex();
    return place < 0 ? -1 : m_choices.at(static_cast<std::size_t>(place)).id;
}

void TriggerBar::choose(int id)
{
    const auto found = std::ranges::find(m_choices, id, &Choice::id);
    if (found != m_choices.end())
        m_trace->setCurrentIndex(static_cast<int>(found - m_choices.begin()));
}

std::optional<TriggerSetup> TriggerBar::setup() const
{
    const std::optional<double> level = parseNumber(m_level->text());
    if (!level)
        return std::nullopt;
    TriggerSetup setup;
    setup.kind = kinds.at(static_cast<std::size_t>(m_kind->currentIndex()));
    setup.level = *level;
    setup.before = parts.at(static_cast<std::size_t>(m_before->currentIndex()));
    setup.mode = m_mode->current() == 1 ? TriggerSetup::Mode::Single : TriggerSetup::Mode::Normal;
    return setup;
}

void TriggerBar::setLevel(double level)
{
    // Four digits are as near as a hand gets; no exponent.
    const double size = level == 0.0 ? 0.0 : std::floor(std::log10(std::abs(level)));
    const double step = std::pow(10.0, size - 3.0);
    m_level->setText(editText(std::round(level / step) * step, std::clamp(3 - static_cast<int>(size), 0, 9)));
    setStyleProperty(*m_level, "state", QString());
}

QString TriggerBar::description(const TriggerSetup &setup, double window) const
{
    const QString sign = m_kind->currentText().section(QLatin1Char(' '), 0, 0);
    const bool edge = setup.kind != TriggerKind::Above && setup.kind != TriggerKind::Below;
    return tr("trigger %1 %2 %3, %4 before")
        .arg(edge ? sign : m_kind->currentText(), formatSignificant(setup.level, 4), m_unit->text(),
            formatDuration(window * setup.before));
}

} // namespace mb
