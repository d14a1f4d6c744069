// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/envelopepanel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/savedlimits.h"
#include "widgets/control/wrappedlabel.h"

#include <QPushButton>

#include <cmath>
#include <utility>

namespace mb {
namespace {

/// How a bound of envelopeBounds is shown.
struct Bound {
    const EnvelopeBound &of;
    const char *name;
    Quantity quantity;
    const char *unit;
};

constexpr std::array<Bound, 4> bounds{{
    {envelopeBounds[0], QT_TRANSLATE_NOOP("mb::EnvelopePanel", "Travel ±"), Quantity::Position, "counts"},
    {envelopeBounds[1], QT_TRANSLATE_NOOP("mb::EnvelopePanel", "Speed"), Quantity::Velocity, "counts/s"},
    {envelopeBounds[2], QT_TRANSLATE_NOOP("mb::EnvelopePanel", "Current"), Quantity::Current, "A"},
    {envelopeBounds[3], QT_TRANSLATE_NOOP("mb::EnvelopePanel", "Duty"), Quantity::Duty, "fraction"},
}};

constexpr int warningLines = 2; ///< so that nothing moves while one types

QString shown(double value, const ShownUnit &unit)
{
    return formatSignificant(value * unit.scale, 4) + QChar(0x00A0) + unit.text;
}

} // namespace

EnvelopePanel::EnvelopePanel(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    auto *column = layoutIn<QVBoxLayout>(this, theme.theme().u(4));
    m_head = linkButton(tr("Envelope"), this);
    m_head->setCheckable(true);
    m_words = wrappedLabel({}, TextRole::Caption, Tone::Dim, this);
    m_box = new QWidget(this);
    auto *grid = layoutIn<QGridLayout>(m_box);
    grid->setHorizontalSpacing(theme.theme().u(8));
    grid->setVerticalSpacing(theme.theme().u(4));
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const QString name = tr(bounds[i].name);
        m_rows[i].field = new NumberField(m_box);
        m_rows[i].field->setAccessibleName(tr("Envelope: %1").arg(name));
        m_rows[i].field->setToolTip(tr("Empty: what the device itself says"));
        m_rows[i].inForce = textLabel({}, TextRole::Caption, Tone::Dim, m_box);
        const int row = static_cast<int>(i);
        grid->addWidget(textLabel(name, TextRole::Body, Tone::Text, m_box), row, 0);
        grid->addWidget(m_rows[i].field, row, 1);
        grid->addWidget(m_rows[i].inForce, row, 2);
        connect(m_rows[i].field, &QLineEdit::textEdited, this, [this, i] { read(i); });
        connect(m_rows[i].field, &QLineEdit::editingFinished, this, [this, i] {
            if (readingOf(i).good)
                m_rows[i].before = m_entered.*bounds[i].of.value;
        });
    }
    grid->setColumnStretch(2, 1);
    m_saved = new SavedLimits(theme, m_box);
    grid->addWidget(m_saved, static_cast<int>(bounds.size()), 0, 1, 3);
    connect(m_saved, &SavedLimits::chosen, this, [this](const QString &name) { take(m_book->named(m_unit, name)); });
    connect(m_saved, &SavedLimits::keepRequested, this, [this](const QString &name) {
        m_book->keep(m_unit, name, m_entered);
        m_saved->setNames(m_book->names(m_unit));
    });
    connect(m_saved, &SavedLimits::forgetRequested, this, [this](const QString &name) {
        m_book->forget(m_unit, name);
        m_saved->setNames(m_book->names(m_unit));
    });
    column->addWidget(m_head, 0, Qt::AlignLeft);
    column->addWidget(m_box);
    column->addWidget(m_words); // below what is typed into: it comes and goes with what is typed
    m_box->hide();
    connect(m_head, &QPushButton::toggled, this, [this](bool open) {
        m_box->setVisible(open);
        say();
    });
    setUnits({});
}

void EnvelopePanel::setOpen(bool open)
{
    m_head->setChecked(open);
}

void EnvelopePanel::setUnits(const DisplayUnits &units)
{
    for (std::size_t i = 0; i < bounds.size(); ++i)
        m_rows[i].unit = shownUnit(bounds[i].quantity, bounds[i].unit, units);
    write();
    say();
}

void EnvelopePanel::choose(const std::string &unit, bool sameDevice)
{
    if (unit == m_unit && (sameDevice || !unit.empty()))
        return look(); // the other page may have changed it
    if (sameDevice && !m_unit.empty())
        m_book->carry(m_unit, unit);
    else if (sameDevice && m_book->entered(unit) == Envelope())
        m_book->enter(unit, m_entered);
    m_unit = unit;
    m_saved->setNames(m_book->names(unit));
    look(!sameDevice);
}

/// `all`: of another device, so that what is being typed is not of this one.
void EnvelopePanel::look(bool all)
{
    if (m_unit.empty() && !all)
        return; // what is entered before it is known who it is waits for that
    const Envelope now = m_book->entered(m_unit);
    const bool other = std::exchange(m_entered, now) != now;
    if (other || all)
        write(all);
    if (other)
        Q_EMIT changed();
}

void EnvelopePanel::take(const Envelope &limits)
{
    m_entered = limits;
    write();
    m_book->enter(m_unit, m_entered);
    Q_EMIT changed();
}

void EnvelopePanel::write(bool all)
{
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        Row &row = m_rows[i];
        const auto value = m_entered.*bounds[i].of.value;
        row.before = value;
        if (all || !row.field->hasFocus())
            row.field->setText(value ? editText(std::round(*value * row.unit.scale * 1e6) / 1e6) : QString());
    }
    showVerdict();
}

/// A field that says no limit leaves what held before it was typed into.
void EnvelopePanel::read(std::size_t at)
{
    const Reading typed = readingOf(at);
    m_entered.*bounds[at].of.value = typed.good ? typed.value : m_rows[at].before;
    showVerdict();
    m_book->enter(m_unit, m_entered);
    Q_EMIT changed();
}

EnvelopePanel::Reading EnvelopePanel::readingOf(std::size_t at) const
{
    const QString text = m_rows[at].field->text().trimmed();
    const auto number = parseNumber(text);
    const auto value = number ? std::optional(*number / m_rows[at].unit.scale) : std::nullopt;
    return {value, text.isEmpty() || (value && isBound(bounds[at].of, *value))};
}

void EnvelopePanel::showVerdict()
{
    m_fault.clear();
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const Row &row = m_rows[i];
        const bool good = readingOf(i).good;
        setStyleProperty(*row.field, "state", good ? QString() : QStringLiteral("error"));
        if (!good && m_fault.isEmpty())
            m_fault = tr("%1: %2 is no limit. It is more than 0, and at most %3.")
                          .arg(tr(bounds[i].name), row.field->text().trimmed(), shown(bounds[i].of.most, row.unit));
    }
    say();
}

void EnvelopePanel::setInForce(const Envelope &inForce, const QString &missing)
{
    if (inForce == m_inForce && missing == m_missing)
        return;
    m_inForce = inForce;
    if (!missing.isEmpty() && m_missing.isEmpty())
        setOpen(true);
    m_missing = missing;
    say();
}

void EnvelopePanel::say()
{
    QStringList parts;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const auto value = m_inForce.*bounds[i].of.value;
        const ShownUnit &unit = m_rows[i].unit;
        m_rows[i].inForce->setText(
            value ? tr("%1 holds").arg(shown(*value, unit)) : tr("not bounded, %1").arg(unit.text));
        if (value)
            parts << shown(*value, unit);
    }
    const bool open = m_box->isVisibleTo(this);
    const QString &wrong = m_fault.isEmpty() ? m_missing : m_fault;
    const QString calm = open ? tr("Empty: what the device itself says") : parts.join(QStringLiteral(" · "));
    m_words->setText(wrong.isEmpty() ? calm : wrong);
    m_words->setMinimumHeight(open ? warningLines * (m_words->fontMetrics().lineSpacing() + 1) : 0);
    setTone(*m_words, wrong.isEmpty() ? Tone::Dim : Tone::Caution);
}

} // namespace mb
