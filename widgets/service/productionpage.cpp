// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/service/productionpage.h"

#include "model/family.h"
#include "model/leaserenewal.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/guarded.h"
#include "widgets/common/holdbutton.h"
#include "widgets/common/keystrip.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/pagekeys.h"
#include "widgets/service/counttiles.h"
#include "widgets/service/journalcard.h"
#include "widgets/service/productionhead.h"
#include "widgets/service/unitchecks.h"
#include "widgets/service/unitlist.h"
#include "widgets/service/verdictof.h"

#include <QApplication>
#include <QCheckBox>
#include <QFile>
#include <QKeyEvent>
#include <QLineEdit>

#include <algorithm>

namespace mb {
namespace {

constexpr std::chrono::milliseconds betweenBeeps{250};
constexpr int unitsWidth = 400;
constexpr int widthForUnits = 960; ///< of the page, so that the verdict keeps its room beside them
constexpr int heightForTiles = 480;
constexpr int heightForKeys = 400;

/// Of the program, not of one of its windows.
struct ProductionLink {
    QString chosen;
};

} // namespace

ProductionPage::ProductionPage(
    Workbench &workbench, std::span<const Family *const> families, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_families(families)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("productionPage"));
    setAccessibleName(tr("Production"));
    setFocusPolicy(Qt::StrongFocus);
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    column->setSizeConstraint(QLayout::SetNoConstraint); // minimumSizeHint() knows what may be left out
    column->addWidget(m_head = new ProductionHead(theme, workbench.kept<ProductionLink>().chosen, this));
    column->addWidget(separatorLine(Qt::Horizontal, this));
    column->addWidget(m_checks = new UnitChecks(theme, this));
    auto *row = new QHBoxLayout;
    const int edge = theme.theme().u(16);
    row->setContentsMargins(edge, edge, edge, edge);
    row->setSpacing(edge);
    row->addWidget(buildBench(), 1);
    row->addWidget(buildUnits());
    column->addLayout(row, 1);
    column->addWidget(separatorLine(Qt::Horizontal, this));
    column->addWidget(m_foot = buildFoot());
    m_renewal.setInterval(LeaseRenewal::period);
    connect(&m_renewal, &QTimer::timeout, this, [this] { m_workbench.send(orders::RenewService{}); });
    connect(&workbench, &Workbench::serviceChanged, this, &ProductionPage::follow);
    connect(&workbench, &Workbench::unitEnded, this, &ProductionPage::ended);
    connect(&workbench, &Workbench::changed, this, &ProductionPage::followBench);
    connect(&theme, &ThemeSource::changed, this, &ProductionPage::follow); // shapes have colours of their own
    connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        m_isActive = state == Qt::ApplicationActive;
        if (!m_isActive)
            arm(false); // also what was ordered a moment ago
    });
    connectHead();
    follow();
}

void ProductionPage::connectHead()
{
    connect(m_head, &ProductionHead::recipeWanted, this, &ProductionPage::askRecipe);
    connect(m_head, &ProductionHead::startWanted, this, &ProductionPage::startOrEnd);
    connect(m_head, &ProductionHead::armWanted, this, [this] { arm(!m_workbench.service().isArmed()); });
    connect(m_head, &ProductionHead::leaveWanted, this, &ProductionPage::leaveRequested);
    connect(m_head, &ProductionHead::serialTaken, this, &ProductionPage::take);
    followBench();
}

void ProductionPage::followBench()
{
    m_head->follow(m_workbench.snapshot(), m_workbench.service());
    m_checks->follow(m_workbench.snapshot(), m_workbench.journal(), m_head->link().toStdString());
}

/// Whoever arms looks at this window: what the hand began elsewhere is no order.
void ProductionPage::arm(bool on)
{
    if (on && !m_isActive)
        return;
    m_workbench.send(orders::ArmService{on});
}

HoldButton &ProductionPage::armButton()
{
    return m_head->armButton();
}

QWidget *ProductionPage::buildBench()
{
    auto *bench = new QWidget(this);
    auto *column = layoutIn<QVBoxLayout>(bench, m_theme.theme().u(12));
    m_motion = textLabel({}, TextRole::Body, Tone::Text, bench);
    m_motion->setObjectName(QStringLiteral("motion"));
    m_motion->setWordWrap(true);
    m_motion->hide(); // until a recipe has a self-test
    m_verdict = new VerdictView(m_theme, bench);
    m_tiles = new CountTiles(m_theme, bench);
    column->addWidget(m_motion);
    column->addWidget(m_verdict, 1);
    column->addWidget(m_tiles);
    return bench;
}

QWidget *ProductionPage::buildUnits()
{
    const Theme &theme = m_theme.theme();
    m_side = new QWidget(this);
    m_side->setFixedWidth(theme.u(unitsWidth));
    auto *column = layoutIn<QVBoxLayout>(m_side);
    column->addWidget(new SectionLabel(tr("Last ten units"), m_side));
    column->addWidget(m_units = new UnitList(m_theme, m_side), 1);
    column->addSpacing(theme.u(8));
    column->addWidget(new JournalCard(m_workbench, m_theme, m_side));
    return m_side;
}

QWidget *ProductionPage::buildFoot()
{
    const Theme &theme = m_theme.theme();
    auto *foot = new QWidget(this);
    auto *row = layoutIn<QHBoxLayout>(foot, -1, {theme.u(16), theme.u(6), theme.u(16), theme.u(6)});
    row->addWidget(new KeyStrip(m_theme,
                       {{QStringLiteral("F5"), tr("test again")}, {QStringLiteral("F8"), tr("set aside")},
                           {QStringLiteral("F2"), tr("serial number")}, {QStringLiteral("F11"), tr("leave")},
                           {QStringLiteral("Esc"), tr("stops every motor")}},
                       foot),
        1, Qt::AlignVCenter);
    m_sound = new QCheckBox(tr("Sound"), foot);
    m_sound->setObjectName(QStringLiteral("sound"));
    m_sound->setChecked(true);
    m_sound->setAccessibleName(tr("Sound with every verdict"));
    m_sound->setFocusPolicy(Qt::NoFocus);
    row->addWidget(m_sound);
    auto *keys = new PageKeys(*this);
    keys->add({Qt::Key_F5}, tr("tests the last unit again"), [this] { testAgain(); });
    keys->add({Qt::Key_F8}, tr("sets it aside, ready for the next"), [this] { setAside(); });
    return foot;
}

void ProductionPage::goToSerial()
{
    m_head->serial().setFocus(Qt::ShortcutFocusReason);
}

void ProductionPage::askRecipe()
{
    askForFile(*this, tr("Open recipe"), tr("Recipes (*.json);;All files (*)"), {},
        [this](const QString &path) { openRecipe(path); });
}

bool ProductionPage::openRecipe(const QString &path)
{
    auto loaded = service::loadRecipe(QFile::encodeName(path).toStdString(), m_families);
    if (!loaded) {
        m_workbench.report(Severity::Danger, {}, errorText(loaded.error()));
        return false;
    }
    m_matter = std::make_shared<const service::RecipeMatter>(std::move(*loaded));
    if (m_workbench.service().running)
        follow();
    else
        setAside(); // verdicts of the recipe before
    return true;
}

void ProductionPage::startOrEnd()
{
    if (m_isOrdered)
        return;
    if (!m_workbench.service().running)
        return start();
    m_isOrdered = true;
    m_workbench.send(orders::FinishService{}, guarded(this, [this](const Result<void> &) { m_isOrdered = false; }));
}

void ProductionPage::start()
{
    const std::string link = m_head->link().toStdString();
    if (!m_matter || link.empty()) {
        m_workbench.report(Severity::Caution, {},
            m_matter ? tr("not started: open a link first") : tr("not started: open a recipe first"));
        return;
    }
    m_setAside.clear();
    m_head->keepLink();
    m_isOrdered = true;
    m_workbench.send(orders::ServeUnits{m_matter, {link}, 0}, guarded(this, [this](const Result<void> &result) {
        m_isOrdered = false;
        if (!result)
            m_workbench.report(Severity::Danger, {}, errorText(result.error()));
    }));
}

void ProductionPage::retry(const service::QueueRow &row)
{
    m_workbench.send(orders::RetryUnit{row.id}, guarded(this, [this, name = nameOf(row)](const Result<void> &result) {
        if (!result)
            m_workbench.report(Severity::Caution, name, tr("not tested again: %1").arg(errorText(result.error())));
    }));
}

void ProductionPage::testAgain()
{
    if (const service::QueueRow *row = lastEnded(m_workbench.service(), m_setAside))
        retry(*row);
}

void ProductionPage::setAside()
{
    setAllAside(m_workbench.service(), m_setAside);
    follow();
}

/// The one that was put on last: those before it were taken off.
void ProductionPage::take(const QString &serial)
{
    if (serial.isEmpty())
        return;
    const auto &rows = m_workbench.service().rows;
    const auto found = std::find_if(rows.rbegin(), rows.rend(),
        [&serial](const service::QueueRow &row) { return nameOf(row).compare(serial, Qt::CaseInsensitive) == 0; });
    if (found != rows.rend())
        retry(*found);
    else
        m_workbench.report(Severity::Caution, {}, tr("no unit here has the serial number %1").arg(serial));
}

/// A scanner is a keyboard: letters, digits and Return go to the serial number wherever the focus is.
void ProductionPage::keyPressEvent(QKeyEvent *event)
{
    const QString text = event->text();
    if (text.size() == 1 && text.at(0).isLetterOrNumber() && event->modifiers() <= Qt::ShiftModifier) {
        m_head->serial().setFocus(Qt::OtherFocusReason);
        m_head->serial().insert(text);
        return;
    }
    QWidget::keyPressEvent(event);
}

void ProductionPage::hideEvent(QHideEvent *event)
{
    arm(false);
    QWidget::hideEvent(event);
}

QSize ProductionPage::minimumSizeHint() const
{
    return {m_theme.theme().u(560), m_theme.theme().u(360)};
}

void ProductionPage::resizeEvent(QResizeEvent *event)
{
    m_side->setVisible(width() >= m_theme.theme().u(widthForUnits));
    m_tiles->setVisible(height() >= m_theme.theme().u(heightForTiles));
    m_checks->setVisible(height() >= m_theme.theme().u(heightForTiles));
    m_foot->setVisible(height() >= m_theme.theme().u(heightForKeys));
    showRecipe(m_workbench.service());
    QWidget::resizeEvent(event);
}

void ProductionPage::follow()
{
    const ServiceView &view = m_workbench.service();
    m_verdict->setVerdict(verdictOf(view, m_setAside, *this, m_matter != nullptr));
    m_tiles->follow(view);
    showRecipe(view);
    m_head->follow(view);
    m_units->follow(view);
    if (const bool announces = view.announced > 0; !std::exchange(m_announced, announces) && announces)
        sound(2);
    if (const bool turns = view.running && view.mayTurn != MayTurn::Nothing; turns != m_renewal.isActive())
        turns ? m_renewal.start() : m_renewal.stop();
}

/// The one of the verdict, which the queue of the page Firmware may have begun; else the one that can be started.
void ProductionPage::showRecipe(const ServiceView &view)
{
    const bool told = view.running || !m_verdict->verdict().unit.isEmpty();
    const bool others = told && view.matter && view.matter != m_matter;
    const service::RecipeMatter *const matter = others ? view.matter.get() : m_matter.get();
    m_head->show(matter, m_matter != nullptr);
    const bool turns = matter && matter->recipe.test;
    m_motion->setText(turns ? tr("The self-test turns the motor: %1").arg(motionOf(*matter->recipe.test)) : QString());
    const Verdict::Kind kind = m_verdict->verdict().kind;
    const bool isJudged = kind != Verdict::Kind::Waiting && kind != Verdict::Kind::Working;
    m_motion->setVisible(
        turns && !(isJudged && height() < m_theme.theme().u(heightForTiles))); // its cause needs the room
}

void ProductionPage::ended(const service::Visit &visit)
{
    sound(visit.outcome == service::Outcome::Passed ? 1 : 3);
}

void ProductionPage::setSound(bool on)
{
    m_sound->setChecked(on);
}

void ProductionPage::sound(int times)
{
    if (!m_sound->isChecked())
        return;
    Q_EMIT sounded(times);
    beep(times);
}

void ProductionPage::beep(int times)
{
    QApplication::beep();
    if (times > 1)
        QTimer::singleShot(betweenBeeps, this, [this, times] { beep(times - 1); });
}

} // namespace mb
