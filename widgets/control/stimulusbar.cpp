// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/stimulusbar.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/stateglyph.h"
#include "widgets/control/trialwords.h"

#include <QComboBox>
#include <QPainter>
#include <QStandardItemModel>

#include <array>
#include <cmath>

namespace mb {
namespace {

using tuning::Profile;

constexpr std::array allKinds{
    Profile::Step, Profile::Square, Profile::Ramp, Profile::Sine, Profile::Chirp, Profile::Prbs};
constexpr std::array repeats{1, 2, 4, 8, 16};
constexpr double longestTime = 3600.0; ///< s

/// What a kind does, as it stands below its name in the list.
QString hintOf(Profile kind)
{
    switch (kind) {
    case Profile::Step: return StimulusBar::tr("there, until it has settled, and back");
    case Profile::Square: return StimulusBar::tr("to and fro, 0.5 Hz");
    case Profile::Ramp: return StimulusBar::tr("evenly there and back");
    case Profile::Sine: return StimulusBar::tr("1 Hz, six swings");
    case Profile::Chirp: return StimulusBar::tr("0.1 to 15 Hz in 30 s");
    case Profile::Prbs: return StimulusBar::tr("random bits of 125 ms");
    }
    return {};
}

/// The shape of a kind, from its own numbers.
QIcon iconOf(Profile kind, const QColor &colour, int size)
{
    QPixmap picture(2 * size, size);
    picture.fill(Qt::transparent);
    const auto stimulus = tuning::Stimulus::make(kind, 0.0, 1.0, std::nullopt, 0.01);
    if (!stimulus)
        return {};
    const double length = std::min(stimulus->length(), kind == Profile::Chirp ? 12.0 : 6.0);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, std::max(1.4, size / 11.0)));
    QPolygonF line;
    for (int x = 0; x < 2 * size; ++x) {
        const double t = (x - size * 0.3) / (1.5 * size) * length;
        const double y = t < 0.0 || t > length ? 0.0 : stimulus->at(t);
        line << QPointF(x + 0.5, size * (0.85 - 0.7 * y));
    }
    painter.drawPolyline(line);
    painter.end();
    return QIcon(picture);
}

} // namespace

StimulusBar::StimulusBar(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    auto *column = layoutIn<QVBoxLayout>(this);
    column->addWidget(buildRow());
    connect(m_kind, qOverload<int>(&QComboBox::activated), this, &StimulusBar::read);
    connect(m_repeat, qOverload<int>(&QComboBox::activated), this, &StimulusBar::read);
    for (QLineEdit *edit : {m_from, m_to, m_seconds})
        connect(edit, &QLineEdit::textEdited, this, &StimulusBar::read);
    connect(&theme, &ThemeSource::changed, this, &StimulusBar::fillKinds);
    fillKinds();
    write();
}

QLineEdit *StimulusBar::field(const QString &name, const QString &tip)
{
    auto *edit = new NumberField(this);
    edit->setAccessibleName(name);
    edit->setToolTip(tip);
    edit->setFixedWidth(m_theme.theme().u(84));
    return edit;
}

QWidget *StimulusBar::buildRow()
{
    const Theme &theme = m_theme.theme();
    auto *box = new QWidget(this);
    auto *row = layoutIn<QHBoxLayout>(box, theme.u(8), {theme.u(12), theme.u(6), theme.u(12), theme.u(6)});
    m_kind = new QComboBox(box);
    m_kind->setAccessibleName(tr("Stimulus"));
    m_from = field(tr("From"), tr("Where the experiment begins and ends; empty: where the motor is, or 0"));
    m_to = field(tr("To"), tr("Where the loop is asked to go"));
    m_unitLabel = textLabel({}, TextRole::Body, Tone::Dim, box);
    m_timeLabel = textLabel(tr("hold"), TextRole::Body, Tone::Dim, box);
    m_seconds = field(tr("Time of the stimulus"), tr("Seconds; empty: the usual, and a step ends once it has settled"));
    const int widest
        = std::max(fontMetrics().horizontalAdvance(tr("settled")), fontMetrics().horizontalAdvance(tr("usual")));
    m_seconds->setFixedWidth(std::max(theme.u(76), widest + theme.u(24)));
    m_repeat = new QComboBox(box);
    m_repeat->setAccessibleName(tr("Repeats"));
    m_repeat->setToolTip(tr(
        "Each repeat starts a little later between two samples: together they show what is finer than the telemetry"));
    for (const int count : repeats)
        m_repeat->addItem(QStringLiteral("× %1").arg(count), count);
    m_glyph = new StateGlyph(m_theme, GlyphState::Gone, box);
    m_verdict = new ElidedLabel({}, box);
    setTone(*m_verdict, Tone::Dim);
    row->addWidget(m_kind, 100);
    row->addWidget(m_from);
    row->addWidget(textLabel(QStringLiteral("▸"), TextRole::Body, Tone::Dim, box));
    row->addWidget(m_to);
    row->addWidget(m_unitLabel);
    row->addWidget(m_timeLabel);
    row->addWidget(m_seconds);
    row->addWidget(textLabel(tr("s"), TextRole::Body, Tone::Dim, box));
    row->addWidget(m_repeat);
    row->addWidget(m_glyph);
    row->addWidget(m_verdict, 1);
    return box;
}

void StimulusBar::fillKinds()
{
    const Theme &theme = m_theme.theme();
    const QSignalBlocker quiet(m_kind);
    m_kind->clear();
    m_kind->setIconSize({2 * theme.u(16), theme.u(16)});
    for (const Profile kind : allKinds) {
        m_kind->addItem(iconOf(kind, theme.text, theme.u(16)), profileText(kind));
        m_kind->setItemData(m_kind->count() - 1, hintOf(kind), Qt::ToolTipRole);
    }
    m_kind->setCurrentIndex(static_cast<int>(m_choice.profile));
    const int hint = m_kind->sizeHint().width();
    m_kind->setMinimumWidth(hint - theme.u(40)); // a narrow page cuts its words before it covers what stands beside it
    m_kind->setMaximumWidth(hint + theme.u(10)); // the sheet's padding is not in the hint
}

void StimulusBar::setUnits(Mode mode, const DisplayUnits &units)
{
    const ShownUnit unit = shownUnit(mode, units);
    const bool same = unit.scale == m_unit.scale && unit.text == m_unit.text;
    m_unit = unit;
    m_from->setPlaceholderText(mode == Mode::Position ? tr("here") : QStringLiteral("0"));
    if (!same)
        write();
}

void StimulusBar::setChoice(const StimulusChoice &choice)
{
    if (choice == m_choice)
        return;
    m_choice = choice;
    write();
}

void StimulusBar::write()
{
    const QSignalBlocker kind(m_kind);
    const QSignalBlocker repeat(m_repeat);
    const auto put = [](QLineEdit *edit, std::optional<double> value, double scale) {
        setStyleProperty(*edit, "state", QString());
        if (!edit->hasFocus() || !value || parseNumber(edit->text()) != *value * scale)
            edit->setText(value ? editText(std::round(*value * scale * 1e6) / 1e6) : QString());
    };
    m_fault.clear();
    m_kind->setCurrentIndex(static_cast<int>(m_choice.profile));
    m_repeat->setCurrentIndex(std::max(0, m_repeat->findData(m_choice.repeat)));
    put(m_from, m_choice.from, m_unit.scale);
    put(m_to, m_choice.to, m_unit.scale);
    put(m_seconds, m_choice.seconds, 1.0);
    m_unitLabel->setText(m_unit.text);
    m_timeLabel->setText(m_choice.profile == Profile::Step ? tr("hold")
            : m_choice.profile == Profile::Ramp            ? tr("rise")
                                                           : tr("time"));
    m_seconds->setPlaceholderText(m_choice.profile == Profile::Step ? tr("settled") : tr("usual"));
}

void StimulusBar::read()
{
    m_fault.clear();
    StimulusChoice choice = m_choice;
    const auto take = [this](QLineEdit *edit, double scale, std::optional<double> &value, bool needed) {
        const auto number = parseNumber(edit->text());
        const bool empty = edit->text().trimmed().isEmpty();
        const bool good = empty ? !needed : number.has_value();
        setStyleProperty(*edit, "state", good ? QString() : QStringLiteral("error"));
        if (good)
            value = number ? std::optional(*number / scale) : std::nullopt;
        else
            m_fault = empty ? tr("Enter where the loop is to go.") : tr("%1 is no number.").arg(edit->text());
    };
    take(m_from, m_unit.scale, choice.from, false);
    take(m_to, m_unit.scale, choice.to, true);
    take(m_seconds, 1.0, choice.seconds, false);
    if (choice.seconds && (*choice.seconds <= 0.0 || *choice.seconds > longestTime)) {
        m_fault = tr("The time is 0.001 to %1 s.").arg(longestTime);
        choice.seconds = m_choice.seconds; // what is looked at ahead must have an end
    }
    const int kind = std::max(0, m_kind->currentIndex());
    choice.profile = allKinds.at(static_cast<std::size_t>(kind));
    choice.repeat = m_repeat->currentData().toInt();
    const bool other = choice.profile != m_choice.profile;
    m_choice = choice;
    if (other)
        write();
    Q_EMIT changed();
}

std::span<const Profile> StimulusBar::kinds()
{
    return allKinds;
}

void StimulusBar::setKindFault(Profile kind, const QString &fault)
{
    auto *rows = qobject_cast<QStandardItemModel *>(m_kind->model());
    QStandardItem *const row = rows ? rows->item(static_cast<int>(kind)) : nullptr;
    if (!row || (row->isEnabled() == fault.isEmpty() && (fault.isEmpty() || row->toolTip() == fault)))
        return;
    row->setEnabled(fault.isEmpty());
    row->setToolTip(fault.isEmpty() ? hintOf(kind) : fault);
}

void StimulusBar::setVerdict(bool good, const QString &text)
{
    m_glyph->setState(good ? GlyphState::Online : GlyphState::Warning);
    m_verdict->setText(text);
}

} // namespace mb
