// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/service/productionpage.h"

#include "model/family.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/holdbutton.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/stateglyph.h"
#include "widgets/common/workbench.h"
#include "widgets/service/verdictof.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>

namespace mb {
namespace {

constexpr std::chrono::milliseconds renewEvery{100};
constexpr std::chrono::milliseconds betweenBeeps{250};
constexpr int shownUnits = 10;
constexpr int unitsWidth = 420;

GlyphState glyphOf(service::RowState state)
{
    switch (state) {
    case service::RowState::Passed: return GlyphState::Done;
    case service::RowState::Failed: return GlyphState::Fault;
    case service::RowState::Refused: return GlyphState::Warning;
    case service::RowState::Running: return GlyphState::Busy;
    case service::RowState::Skipped: return GlyphState::Volatile;
    case service::RowState::Waiting: break;
    }
    return GlyphState::Waiting;
}

} // namespace

ProductionPage::ProductionPage(ServiceDesk &desk, Workbench &workbench, std::span<const Family *const> families,
    const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_desk(desk)
    , m_workbench(workbench)
    , m_families(families)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("productionPage"));
    setAccessibleName(tr("Production"));
    setFocusPolicy(Qt::StrongFocus);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(buildHead());
    column->addWidget(separatorLine(Qt::Horizontal, this));
    auto *row = new QHBoxLayout;
    const int edge = theme.theme().u(16);
    row->setContentsMargins(edge, edge, edge, edge);
    row->setSpacing(edge);
    row->addWidget(buildBench(), 1);
    row->addWidget(buildUnits());
    column->addLayout(row, 1);
    column->addWidget(separatorLine(Qt::Horizontal, this));
    column->addWidget(buildFoot());
    m_renewal.setInterval(renewEvery);
    connect(&m_renewal, &QTimer::timeout, this, [this] { m_desk.renew(); });
    connect(&desk, &ServiceDesk::changed, this, &ProductionPage::follow);
    connect(&desk, &ServiceDesk::unitEnded, this, &ProductionPage::ended);
    connect(&workbench, &Workbench::changed, this, &ProductionPage::followLinks);
    connect(&theme, &ThemeSource::changed, this, &ProductionPage::follow); // shapes have colours of their own
    connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (state != Qt::ApplicationActive && m_desk.view().armed)
            m_desk.arm(false);
    });
    followLinks();
    follow();
}

QWidget *ProductionPage::buildHead()
{
    const Theme &theme = m_theme.theme();
    auto *head = new QWidget(this);
    auto *row = new QHBoxLayout(head);
    row->setContentsMargins(theme.u(16), theme.u(10), theme.u(16), theme.u(10));
    row->setSpacing(theme.u(12));
    m_recipe = textLabel(tr("No recipe yet"), TextRole::Title, Tone::Text, head);
    m_link = new QComboBox(head);
    m_link->setAccessibleName(tr("Link that units are put on"));
    auto *open = new CommandButton(m_theme, Symbol::Open, tr("Open recipe…"), head);
    m_start = new CommandButton(m_theme, Symbol::Play, tr("Start"), head);
    m_start->setPrimary(true);
    m_start->setTextVariants({tr("Start"), tr("End")});
    m_arm = new HoldButton(m_theme, Symbol::Arm, tr("Hold to arm self-tests"), head);
    m_arm->setHoldNeeded(true);
    auto *leave = new CommandButton(m_theme, tr("Leave"), head);
    leave->setKeyHint(QStringLiteral("F11"));
    row->addWidget(m_recipe, 1);
    for (QWidget *part : std::initializer_list<QWidget *>{m_link, open, m_start, m_arm, leave})
        row->addWidget(part);
    connect(open, &QPushButton::clicked, this, &ProductionPage::askRecipe);
    connect(m_start, &QPushButton::clicked, this, [this] { m_desk.view().running ? m_desk.finish() : start(); });
    connect(m_arm, &HoldButton::activated, this, [this] { m_desk.arm(!m_desk.view().armed); });
    connect(leave, &QPushButton::clicked, this, &ProductionPage::leaveRequested);
    return head;
}

QWidget *ProductionPage::buildBench()
{
    auto *bench = new QWidget(this);
    auto *column = new QVBoxLayout(bench);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(m_theme.theme().u(12));
    m_motion = textLabel({}, TextRole::Emphasis, Tone::Dim, bench);
    m_motion->setWordWrap(true);
    m_verdict = new VerdictView(m_theme, bench);
    m_counts = textLabel({}, TextRole::Large, Tone::Text, bench);
    m_counts->setWordWrap(true);
    column->addWidget(m_motion);
    column->addWidget(m_verdict, 1);
    column->addWidget(m_counts);
    return bench;
}

QWidget *ProductionPage::buildUnits()
{
    const Theme &theme = m_theme.theme();
    auto *side = new QWidget(this);
    side->setFixedWidth(theme.u(unitsWidth));
    auto *column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(new SectionLabel(tr("Last ten units"), side));
    m_units = new QListWidget(side);
    m_units->setAccessibleName(tr("Last ten units, newest first"));
    m_units->setFocusPolicy(Qt::NoFocus);
    m_units->setWordWrap(true);
    column->addWidget(m_units, 1);
    m_serial = new QLineEdit(side);
    m_serial->setAccessibleName(tr("Serial number, scanned or typed"));
    m_serial->setPlaceholderText(tr("Scan or type a serial number"));
    column->addWidget(m_serial);
    connect(m_serial, &QLineEdit::returnPressed, this, [this] {
        take(m_serial->text().trimmed());
        m_serial->clear();
    });
    return side;
}

QWidget *ProductionPage::buildFoot()
{
    const Theme &theme = m_theme.theme();
    auto *foot = new QWidget(this);
    auto *row = new QHBoxLayout(foot);
    row->setContentsMargins(theme.u(16), theme.u(6), theme.u(16), theme.u(6));
    row->addWidget(textLabel(tr("F5 test again · F8 set aside · F2 serial number · F11 leave · Esc stops every motor"),
        TextRole::Caption, Tone::Dim, foot));
    row->addStretch(1);
    auto *sound = new QCheckBox(tr("Sound"), foot);
    sound->setChecked(m_sound);
    sound->setAccessibleName(tr("Sound with every verdict"));
    sound->setFocusPolicy(Qt::NoFocus);
    row->addWidget(sound);
    connect(sound, &QCheckBox::toggled, this, &ProductionPage::setSound);
    auto *keys = new PageKeys(*this);
    keys->add({Qt::Key_F5}, tr("tests the last unit again"), [this] { testAgain(); });
    keys->add({Qt::Key_F8}, tr("sets it aside, ready for the next"), [this] { setAside(); });
    keys->add({Qt::Key_F2}, tr("goes to the serial number"), [this] { m_serial->setFocus(Qt::ShortcutFocusReason); });
    return foot;
}

void ProductionPage::askRecipe()
{
    auto *dialog = new QFileDialog(this, tr("Open recipe"), QString(), tr("Recipes (*.json);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::fileSelected, this, &ProductionPage::openRecipe);
    dialog->open();
}

bool ProductionPage::openRecipe(const QString &path)
{
    auto loaded = service::loadRecipe(QFile::encodeName(path).toStdString(), m_families);
    if (!loaded) {
        m_workbench.report(Severity::Danger, {}, errorText(loaded.error()));
        return false;
    }
    m_matter = std::make_shared<const service::RecipeMatter>(std::move(*loaded));
    const service::Recipe &recipe = m_matter->recipe;
    QStringList parts{qt(recipe.name)};
    if (recipe.firmware)
        parts << tr("firmware %1").arg(qt(m_matter->imageVersion));
    if (!m_matter->parameters.empty())
        parts << tr("%1 parameters").arg(m_matter->parameters.size());
    if (recipe.number)
        parts << tr("next free number from %1").arg(recipe.number->first);
    m_recipe->setText(parts.join(QStringLiteral(" · ")));
    m_motion->setText(recipe.test ? tr("The self-test turns the motor: %1").arg(motionOf(*recipe.test)) : QString());
    follow();
    return true;
}

void ProductionPage::start()
{
    const std::string link = m_link->currentData().toString().toStdString();
    if (!m_matter || link.empty()) {
        m_workbench.report(Severity::Caution, {},
            m_matter ? tr("not started: open a link first") : tr("not started: open a recipe first"));
        return;
    }
    m_setAside.clear();
    m_desk.begin({m_matter, {link}, 0}, [self = QPointer<ProductionPage>(this)](const Result<void> &result) {
        if (self && !result)
            self->m_workbench.report(Severity::Danger, {}, errorText(result.error()));
    });
}

void ProductionPage::testAgain()
{
    if (const service::QueueRow *row = lastEnded(m_desk.view(), m_setAside))
        m_desk.retry(row->id);
}

void ProductionPage::setAside()
{
    for (const service::QueueRow &row : m_desk.view().rows)
        m_setAside.push_back(row.id);
    follow();
}

void ProductionPage::take(const QString &serial)
{
    for (const service::QueueRow &row : m_desk.view().rows) {
        if (!serial.isEmpty() && nameOf(row).compare(serial, Qt::CaseInsensitive) == 0)
            return m_desk.retry(row.id);
    }
    if (!serial.isEmpty())
        m_workbench.report(Severity::Caution, {}, tr("no unit here has the serial number %1").arg(serial));
}

/// A scanner is a keyboard: letters, digits and Return go to the serial number wherever the focus is.
void ProductionPage::keyPressEvent(QKeyEvent *event)
{
    const QString text = event->text();
    if (text.size() == 1 && text.at(0).isLetterOrNumber() && event->modifiers() <= Qt::ShiftModifier) {
        m_serial->setFocus(Qt::OtherFocusReason);
        m_serial->insert(text);
        return;
    }
    QWidget::keyPressEvent(event);
}

void ProductionPage::hideEvent(QHideEvent *event)
{
    m_desk.arm(false);
    QWidget::hideEvent(event);
}

void ProductionPage::followLinks()
{
    const auto &links = m_workbench.snapshot().links;
    QStringList addresses;
    for (const LinkView &link : links) {
        if (link.state == LinkState::Open)
            addresses << qt(link.address);
    }
    QStringList known;
    for (int i = 0; i < m_link->count(); ++i)
        known << m_link->itemData(i).toString();
    if (addresses == known)
        return;
    const QString before = m_link->currentData().toString();
    m_link->clear();
    for (const QString &address : addresses)
        m_link->addItem(address, address);
    m_link->setCurrentIndex(std::max(0, m_link->findData(before)));
}

void ProductionPage::follow()
{
    const ServiceView &view = m_desk.view();
    m_verdict->setVerdict(verdictOf(view, m_setAside));
    const auto mean = meanSeconds(view);
    m_counts->setText(tr("%1 passed   %2 failed   %3 refused   mean %4")
                          .arg(view.counts.passed)
                          .arg(view.counts.failed)
                          .arg(view.counts.refused)
                          .arg(mean ? formatNumber(*mean, 1) + QStringLiteral("\u00A0s") : QString(UnknownMark)));
    m_start->setText(view.running ? tr("End") : tr("Start"));
    m_start->setSymbol(view.running ? Symbol::Pause : Symbol::Play);
    m_link->setEnabled(!view.running);
    const bool moves = m_matter && m_matter->recipe.test;
    m_arm->setVisible(moves);
    m_arm->setEnabled(view.running);
    m_arm->setText(view.armed ? tr("ARMED, hold to disarm") : tr("Hold to arm self-tests"));
    if (const bool turns = view.running && view.armed; turns != m_renewal.isActive())
        turns ? m_renewal.start() : m_renewal.stop();
    m_units->clear();
    const int count = static_cast<int>(view.rows.size());
    for (int i = count - 1; i >= std::max(0, count - shownUnits); --i) {
        const service::QueueRow &row = view.rows[static_cast<std::size_t>(i)];
        const QString number = row.visit.number ? QStringLiteral("  #%1").arg(*row.visit.number) : QString();
        m_units->addItem(new QListWidgetItem(
            glyphIcon(glyphOf(row.state), m_theme.theme()), nameOf(row) + number + QLatin1Char('\n') + lineOf(row)));
    }
}

void ProductionPage::ended(const service::Visit &visit)
{
    std::erase_if(m_setAside, [this, &visit](std::uint32_t id) {
        const auto &rows = m_desk.view().rows;
        return std::any_of(rows.begin(), rows.end(),
            [&](const service::QueueRow &row) { return row.id == id && row.visit.unit == visit.unit; });
    });
    if (m_sound)
        beep(visit.outcome == service::Outcome::Passed ? 1 : 3);
}

void ProductionPage::beep(int times)
{
    QApplication::beep();
    if (times > 1)
        QTimer::singleShot(betweenBeeps, this, [this, times] { beep(times - 1); });
}

} // namespace mb
