"""Words of the pages that the server writes itself, in the languages that they speak."""

from __future__ import annotations

from housefly.web.http.page_language import PageLanguage

_JAPANESE: dict[str, str] = {
    "Who is there?": "どなたですか",
    "Name": "名前",
    "Password": "パスワード",
    "Log in": "ログイン",
    "Log out": "ログアウト",
    "No user has this name and this password.": "この名前とパスワードの利用者はいません。",
    "Too many tries: wait a minute.": "試行回数が多すぎます。1分お待ちください。",
    "This link was already used, or is too old": "このリンクは使用済みか、期限切れです",
    (
        "A link opens the console in one browser only, and an invitation waits 10 minutes for"
        " it, so that nobody can fly the drone with a link that was left lying about. If you"
        " have not used it, somebody else may have: tell who runs Housefly."
    ): (
        "リンクでコンソールを開けるブラウザーは1つだけで、招待は10分で切れます。置き忘れたリンク"
        "で誰かがドローンを飛ばすことを防ぐためです。ご自分で使っていない場合は、ほかの人が使った"
        "可能性があります。Houseflyの管理者に知らせてください。"
    ),
    (
        "For another browser or person: open “Control” in a console that is already open and"
        " choose “Invite”. It makes a fresh link. Without an open console, press Enter where"
        " Housefly runs for others on the network, or start it again; it prints a new address."
    ): (
        "別のブラウザーや人のためには、開いているコンソールの「操縦」から「招待」を選んでください"
        "。新しいリンクができます。開いているコンソールがなければ、ネットワークに公開して動かして"
        "いるHouseflyの端末でEnterキーを押すか、起動し直してください。新しいアドレスが表示されま"
        "す。"
    ),
    "I have the console open in this browser": "このブラウザーでコンソールを開いています",
    "One more step": "あと一歩です",
    "The link has opened the console in this browser.": (
        "リンクにより、このブラウザーでコンソールが開きました。"
    ),
    "Show the console": "コンソールを表示",
    "There is nothing to trust here": "ここに信頼すべき証明書はありません",
    "This console has no certificate of its own authority: nothing need be installed for it.": (
        "このコンソールには独自の認証局の証明書がありません。何も入れる必要はありません。"
    ),
    "Open the console": "コンソールを開く",
    (
        "This browser does not have the console open yet. Use the address that Housefly printed"
        " when it started; it looks like http://127.0.0.1:8080/?token=… and opens the console in"
        " one browser."
    ): (
        "このブラウザーではまだコンソールを開いていません。Houseflyの起動時に表示されたアドレスを"
        "使ってください。http://127.0.0.1:8080/?token=…"
        " のような形で、1つのブラウザーでコンソールが開きます。"
    ),
    "If you came here through such a link on another page, try again:": (
        "別のページのリンクから来た場合は、もう一度お試しください。"
    ),
    "This address was already used": "このアドレスは使用済みです",
    (
        "The address that `housefly new` printed opens the page in one browser. Go on there, or"
        " end the command with Ctrl+C and start it again: it prints a fresh address, and the"
        " draft is as you left it."
    ): (
        "housefly new が表示したアドレスでページを開けるブラウザーは1つだけです。そのブラウザーで"
        "続けるか、Ctrl+Cで終了して起動し直してください。新しいアドレスが表示され、下書きはそのま"
        "ま残っています。"
    ),
    "I have the page open in this browser": "このブラウザーでページを開いています",
    "Your session": "あなたのセッション",
    "You are {user}; your role is “{role}”. STOP and LAND are for everybody.": (
        "{user}さんとしてログイン中です。役割は「{role}」です。STOPと着陸は誰でも使えます。"
    ),
    "You came in by a one-time link; your role is “{role}”. STOP and LAND are for everybody.": (
        "一度だけのリンクで入りました。役割は「{role}」です。STOPと着陸は誰でも使えます。"
    ),
    "watch": "見る",
    "ask": "頼む",
    "fly": "飛ばす",
    "admin": "管理",
    "Back to the console": "コンソールへ戻る",
    "You are logged out": "ログアウトしました",
    "Every window of this session is closed to it. The drone goes on with what it does.": (
        "このセッションのすべての画面が閉じられました。ドローンは今の動作を続けます。"
    ),
    "Log in again": "もう一度ログイン",
}

_GERMAN: dict[str, str] = {
    "Who is there?": "Wer ist da?",
    "Name": "Name",
    "Password": "Passwort",
    "Log in": "Anmelden",
    "Log out": "Abmelden",
    "No user has this name and this password.": "Niemand hat diesen Namen und dieses Passwort.",
    "Too many tries: wait a minute.": "Zu viele Versuche: eine Minute warten.",
    "This link was already used, or is too old": "Dieser Link wurde schon benutzt oder ist zu alt",
    (
        "A link opens the console in one browser only, and an invitation waits 10 minutes for"
        " it, so that nobody can fly the drone with a link that was left lying about. If you"
        " have not used it, somebody else may have: tell who runs Housefly."
    ): (
        "Ein Link öffnet die Konsole nur in einem Browser, und eine Einladung wartet 10 Minuten"
        " darauf, damit niemand die Drohne mit einem liegen gelassenen Link fliegen kann. Haben"
        " Sie ihn nicht benutzt, dann vielleicht jemand anders: Sagen Sie es denen, die Housefly"
        " betreiben."
    ),
    (
        "For another browser or person: open “Control” in a console that is already open and"
        " choose “Invite”. It makes a fresh link. Without an open console, press Enter where"
        " Housefly runs for others on the network, or start it again; it prints a new address."
    ): (
        "Für einen anderen Browser oder Menschen: in einer offenen Konsole „Steuerung“ öffnen"
        " und „Einladen“ wählen. Das ergibt einen neuen Link. Ohne offene Konsole dort, wo"
        " Housefly für andere im Netz läuft, Enter drücken oder es neu starten; es gibt eine"
        " neue Adresse aus."
    ),
    "I have the console open in this browser": "Ich habe die Konsole in diesem Browser offen",
    "One more step": "Noch ein Schritt",
    "The link has opened the console in this browser.": (
        "Der Link hat die Konsole in diesem Browser geöffnet."
    ),
    "Show the console": "Konsole zeigen",
    "There is nothing to trust here": "Hier ist nichts zu bestätigen",
    "This console has no certificate of its own authority: nothing need be installed for it.": (
        "Diese Konsole hat kein Zertifikat einer eigenen Stelle: Dafür muss nichts installiert"
        " werden."
    ),
    "Open the console": "Konsole öffnen",
    (
        "This browser does not have the console open yet. Use the address that Housefly printed"
        " when it started; it looks like http://127.0.0.1:8080/?token=… and opens the console in"
        " one browser."
    ): (
        "Dieser Browser hat die Konsole noch nicht offen. Nehmen Sie die Adresse, die Housefly"
        " beim Start ausgab; sie sieht aus wie http://127.0.0.1:8080/?token=… und öffnet die"
        " Konsole in einem Browser."
    ),
    "If you came here through such a link on another page, try again:": (
        "Wer durch so einen Link auf einer anderen Seite hierher kam, versuche es noch einmal:"
    ),
    "This address was already used": "Diese Adresse wurde schon benutzt",
    (
        "The address that `housefly new` printed opens the page in one browser. Go on there, or"
        " end the command with Ctrl+C and start it again: it prints a fresh address, and the"
        " draft is as you left it."
    ): (
        "Die Adresse, die housefly new ausgab, öffnet die Seite in einem Browser. Dort"
        " weitermachen oder den Befehl mit Strg+C beenden und neu starten: Er gibt eine neue"
        " Adresse aus, und der Entwurf ist, wie er war."
    ),
    "I have the page open in this browser": "Ich habe die Seite in diesem Browser offen",
    "Your session": "Ihre Sitzung",
    "You are {user}; your role is “{role}”. STOP and LAND are for everybody.": (
        "Sie sind {user}; Ihre Rolle ist „{role}“. STOP und Landen sind für alle."
    ),
    "You came in by a one-time link; your role is “{role}”. STOP and LAND are for everybody.": (
        "Sie kamen durch einen einmaligen Link; Ihre Rolle ist „{role}“. STOP und Landen sind"
        " für alle."
    ),
    "watch": "zusehen",
    "ask": "bitten",
    "fly": "fliegen",
    "admin": "verwalten",
    "Back to the console": "Zurück zur Konsole",
    "You are logged out": "Sie sind abgemeldet",
    "Every window of this session is closed to it. The drone goes on with what it does.": (
        "Jedes Fenster dieser Sitzung ist geschlossen. Die Drohne macht weiter, was sie tut."
    ),
    "Log in again": "Wieder anmelden",
}

PAGE_WORDS: dict[PageLanguage, dict[str, str]] = {
    PageLanguage.JAPANESE: _JAPANESE,
    PageLanguage.GERMAN: _GERMAN,
}
"""By their English."""


def page_words(language: PageLanguage, english: str, **values: str) -> str:
    """Return words of a page in a language, with values in; English where nobody has put them so.

    Args:
        language: of the page.
        english: the words, ``{name}`` where a value goes.
        values: by name.
    """
    own = PAGE_WORDS.get(language, {}).get(english, english)
    return own.format(**values) if values else own
