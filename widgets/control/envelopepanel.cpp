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

struct Bound {
    std::optional<double> Envelope::*value;
    const char *name;
    Quantity quantity;
    const char *unit;
};

constexpr std::array<Bound, 4> bounds{{
    {&Envelope::travel, QT_TRANSLATE_NOOP("mb::EnvelopePanel", "Travel ±"), Quantity::Position, "counts"},
    {&Envelope::speed, QT_TRANSLATE_NOOP("mb::EnvelopePanel", "Speed"), Quantity::Velocity, "counts/s"},
    {&Envelope::current, QT_TRANSLATE_NOOP("mb::EnvelopePanel", "Current"), Quantity::Current, "A"},
    {&Envelope::duty, QT_TRANSLATE_NOOP("mb::EnvelopePanel", "Duty"), Quantity::Duty, "fraction"},
}};

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
        connect(m_rows[i].field, &QLineEdit::textEdited, this, &EnvelopePanel::read);
    }
    grid->setColumnStretch(2, 1);
    m_saved = new SavedLimits(theme, m_box);
    grid->addWidget(m_saved, static_cast<int>(bounds.size()), 0, 1, 3);
    connect(m_saved, &SavedLimits::chosen, this, [this](const QString &name) { take(m_book->named(m_unit, name)); });
    connect(m_saved, &SavedLimits::keepRequested, this,
        [this](const QString &name) { told(m_book->keep(m_unit, name, m_entered)); });
    connect(m_saved, &SavedLimits::forgetRequested, this,
        [this](const QString &name) { told(m_book->forget(m_unit, name)); });
    column->addWidget(m_head, 0, Qt::AlignLeft);
    column->addWidget(m_words);
    column->addWidget(m_box);
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
    if (unit == m_unit)
        return look(); // the other page may have changed it
    if (sameDevice && !m_unit.empty())
        told(m_book->carry(m_unit, unit));
    else if (sameDevice && m_book->entered(unit) == Envelope())
        told(m_book->enter(unit, m_entered));
    m_unit = unit;
    m_saved->setNames(m_book->names(unit));
    look();
}

void EnvelopePanel::look()
{
    const Envelope now = m_book->entered(m_unit);
    if (m_unit.empty() || std::exchange(m_entered, now) == now)
        return;
    write();
    Q_EMIT changed();
}

void EnvelopePanel::take(const Envelope &limits)
{
    m_entered = limits;
    write();
    told(m_book->enter(m_unit, m_entered));
    Q_EMIT changed();
}

void EnvelopePanel::told(const Result<void> &result)
{
    m_saved->setNames(m_book->names(m_unit));
    if (!result)
        Q_EMIT failed(errorText(result.error()));
}

void EnvelopePanel::write()
{
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const auto value = m_entered.*bounds[i].value;
        setStyleProperty(*m_rows[i].field, "state", QString());
        if (!m_rows[i].field->hasFocus())
            m_rows[i].field->setText(
                value ? editText(std::round(*value * m_rows[i].unit.scale * 1e6) / 1e6) : QString());
    }
}

void EnvelopePanel::read()
{
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const QString text = m_rows[i].field->text().trimmed();
        const auto number = parseNumber(text);
        const bool good = text.isEmpty() || (number && *number > 0.0);
        setStyleProperty(*m_rows[i].field, "state", good ? QString() : QStringLiteral("error"));
        if (good)
            m_entered.*bounds[i].value
                = number ? std::optional(*number / m_rows[i].unit.scale) : std::optional<double>();
    }
    told(m_book->enter(m_unit, m_entered));
    Q_EMIT changed();
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
        const auto value = m_inForce.*bounds[i].value;
        const ShownUnit &unit = m_rows[i].unit;
        const QString number
            = value ? formatSignificant(*value * unit.scale, 4) + QChar(0x00A0) + unit.text : QString();
        m_rows[i].inForce->setText(value ? tr("%1 holds").arg(number) : tr("not bounded, %1").arg(unit.text));
        if (value)
            parts << number;
    }
    m_words->setText(m_missing.isEmpty() ? parts.join(QStringLiteral(" · ")) : m_missing);
    m_words->setVisible(!m_box->isVisibleTo(this) || !m_missing.isEmpty());
    setTone(*m_words, m_missing.isEmpty() ? Tone::Dim : Tone::Caution);
}

} // namespace mb
