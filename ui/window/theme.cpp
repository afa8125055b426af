// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/theme.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusVariant>
#include <QToolTip>

#include "ui/window/style.h"

#include <array>
#include <utility>

namespace trixel::ui {

namespace {

constexpr std::array<std::pair<Theme, const char*>, 3> kNames{
    {{Theme::System, "system"}, {Theme::Dark, "dark"}, {Theme::Light, "light"}}};

/// The few tones a theme is made of.
struct Tones
{
    QColor window, base, alternate, button, text, faint, accent, accentText, light, dark;
};

QPalette paletteOf(const Tones& tones)
{
    QPalette p;
    p.setColor(QPalette::Window, tones.window);
    p.setColor(QPalette::WindowText, tones.text);
    p.setColor(QPalette::Base, tones.base);
    p.setColor(QPalette::AlternateBase, tones.alternate);
    p.setColor(QPalette::ToolTipBase, tones.base);
    p.setColor(QPalette::ToolTipText, tones.text);
    p.setColor(QPalette::PlaceholderText, tones.faint);
    p.setColor(QPalette::Text, tones.text);
    p.setColor(QPalette::Button, tones.button);
    p.setColor(QPalette::ButtonText, tones.text);
    p.setColor(QPalette::BrightText, Qt::white);
    p.setColor(QPalette::Light, tones.light);
    p.setColor(QPalette::Midlight, tones.button.lighter(110));
    p.setColor(QPalette::Mid, tones.dark);
    p.setColor(QPalette::Dark, tones.dark);
    p.setColor(QPalette::Shadow, QColor(0, 0, 0));
    p.setColor(QPalette::Highlight, tones.accent);
    p.setColor(QPalette::HighlightedText, tones.accentText);
    p.setColor(QPalette::Link, tones.accent.lighter(125));
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        p.setColor(QPalette::Disabled, role, tones.faint);
    }
    p.setColor(QPalette::Disabled, QPalette::Highlight, tones.button);
    p.setColor(QPalette::Disabled, QPalette::HighlightedText, tones.faint);
    return p;
}

/// The desktop portal's colour preference: 1 dark, 2 light; nothing without a portal or a wish.
std::optional<bool> portalIsDark()
{
    const QDBusConnection bus = QDBusConnection::sessionBus();
    if (!bus.isConnected()) {
        return std::nullopt;
    }
    QDBusMessage question = QDBusMessage::createMethodCall("org.freedesktop.portal.Desktop",
                                                           "/org/freedesktop/portal/desktop",
                                                           "org.freedesktop.portal.Settings",
                                                           "Read");
    question << QString("org.freedesktop.appearance") << QString("color-scheme");
    constexpr int kPatienceMs = 150;
    const QDBusMessage answer = bus.call(question, QDBus::Block, kPatienceMs);
    if (answer.type() != QDBusMessage::ReplyMessage || answer.arguments().isEmpty()) {
        return std::nullopt;
    }
    QVariant value = answer.arguments().constFirst();
    while (value.canConvert<QDBusVariant>()) {
        value = value.value<QDBusVariant>().variant();
    }
    const uint wish = value.toUInt();
    return wish == 1 || wish == 2 ? std::optional(wish == 1) : std::nullopt;
}

} // namespace

QString nameOf(Theme theme)
{
    return kNames[static_cast<std::size_t>(theme)].second;
}

std::optional<Theme> themeFromName(const QString& name)
{
    for (const auto& [theme, known] : kNames) {
        if (name == QLatin1String(known)) {
            return theme;
        }
    }
    return std::nullopt;
}

QPalette darkPalette()
{
    return paletteOf({.window = QColor(0x2d2d2d),
                      .base = QColor(0x222222),
                      .alternate = QColor(0x292929),
                      .button = QColor(0x3c3c3c),
                      .text = QColor(0xe4e4e4),
                      .faint = QColor(0x8a8a8a),
                      .accent = QColor(0x2f78b7),
                      .accentText = QColor(0xffffff),
                      .light = QColor(0x4c4c4c),
                      .dark = QColor(0x1c1c1c)});
}

QPalette lightPalette()
{
    return paletteOf({.window = QColor(0xececec),
                      .base = QColor(0xfbfbfb),
                      .alternate = QColor(0xf2f2f2),
                      .button = QColor(0xe2e2e2),
                      .text = QColor(0x1d1d1d),
                      .faint = QColor(0x7a7a7a),
                      .accent = QColor(0x2a6ca6),
                      .accentText = QColor(0xffffff),
                      .light = QColor(0xffffff),
                      .dark = QColor(0xa8a8a8)});
}

bool systemIsDark()
{
    if (const std::optional<bool> wish = portalIsDark()) {
        return *wish;
    }
    if (qEnvironmentVariableIsEmpty("XDG_CURRENT_DESKTOP")) {
        return true;
    }
    constexpr int kMiddle = 128;
    static const bool startedDark = QApplication::palette().window().color().lightness() < kMiddle;
    return startedDark;
}

void applyTheme(Theme theme)
{
    // Asked even when not needed: later the palette at start is no longer to be seen.
    const bool systemDark = systemIsDark();
    const bool dark = theme == Theme::Dark || (theme == Theme::System && systemDark);
    QApplication::setStyle(new Style); // the application owns it
    const QPalette palette = dark ? darkPalette() : lightPalette();
    QApplication::setPalette(palette);
    QToolTip::setPalette(palette);
}

} // namespace trixel::ui
