// What the server says in English, in German: templates of its sentences.
import type { Templates } from "./speech";

export const DE_TOLD: Templates = {
  // headlines and what is said beside them
  "Waiting for the pilot": "Warten auf den Autopiloten",
  "No contact with the pilot": "Keine Verbindung zum Autopiloten",
  "No contact with the pilot.": "Keine Verbindung zum Autopiloten.",
  "No contact with the drone": "Keine Verbindung zur Drohne",
  "Waiting for the drone": "Warten auf die Drohne",
  "Motors are cut": "Motoren sind aus",
  "Stopped": "Angehalten",
  "HOLDING FOR SAFETY": "SICHERHEITSHALT",
  "Coming home for safety": "Kommt zur Sicherheit zurück",
  "Landing for safety": "Landet zur Sicherheit",
  "Sinking for safety": "Sinkt zur Sicherheit",
  "Cutting motors": "Motoren werden abgeschaltet",
  "Your drone is home": "Die Drohne ist zu Hause",
  "Not ready": "Nicht bereit",
  "Not on the pad": "Nicht auf dem Landeplatz",
  "On the pad": "Auf dem Landeplatz",
  "On the ground": "Am Boden",
  "Taking off": "Startet",
  "Flying to {goal}": "Fliegt zu {goal}",
  "Looking at {goal}": "Sieht nach: {goal}",
  "Coming home": "Kommt zurück",
  "Landing": "Landet",
  "Hovering": "Schwebt",
  "Moved by hand": "Von Hand bewegt",
  "Moved by hand by {who}": "Von {who} von Hand bewegt",
  "hovers when it is let go": "schwebt nach dem Loslassen",
  "motors are off": "Motoren sind aus",
  "looking whether all is well": "prüft, ob alles in Ordnung ist",
  "waiting for an order": "wartet auf einen Befehl",
  "Looking around": "Sieht sich um",
  "Looking for {thing}": "Sucht: {thing}",
  "Following {who}": "Folgt: {who}",
  "Paused": "Angehalten",
  "waits until you press Go on": "wartet, bis Sie „Weiter“ drücken",
  "{n} s left": "noch {n} s",
  "comes home by itself": "kommt von selbst zurück",
  "{d} m, {n} s left": "noch {d} m, {n} s",
  "{d} m left": "noch {d} m",
  "{place}; may take off from there": "{place}; Start von dort möglich",
  "{place}; reset before the next flight": "{place}; vor dem nächsten Flug zurücksetzen",
  "{place}; stays down until you resume": "{place}; bleibt unten bis „Fortsetzen“",
  "hovers until you resume": "schwebt bis „Fortsetzen“",
  "for {n} s; {then}": "seit {n} s; {then}",
  "it was on the ground": "sie war am Boden",
  "it was hovering": "sie schwebte",
  "it was taking off": "sie startete",
  "it was flying to {goal}": "sie flog zu {goal}",
  "it was looking at {goal}": "sie sah nach: {goal}",
  "it was coming home": "sie kam zurück",
  "it was landing": "sie landete",
  "it was moved by hand": "sie wurde von Hand bewegt",
  "it was moved by hand by {who}": "sie wurde von {who} von Hand bewegt",
  "its goal": "ihrem Ziel",
  "the chosen point": "dem gewählten Punkt",
  "home": "Heim",
  "on the pad": "auf dem Landeplatz",
  "on the ground, {d} m from the pad": "am Boden, {d} m vom Landeplatz",
  "on the ground, {d} m from the pad, under, on or in {thing}":
    "am Boden, {d} m vom Landeplatz, unter, auf oder in {thing}",
  "on the ground; {why}": "am Boden; {why}",
  "in the air": "in der Luft",
  "in the air; {why}": "in der Luft; {why}",
  "not known": "unbekannt",
  "tracking has not seen it yet": "die Ortung sah sie noch nicht",
  "tracking saw it last {n} s ago": "die Ortung sah sie zuletzt vor {n} s",
  "tracking does not see it": "die Ortung sieht sie nicht",
  "tracking has not seen the drone yet": "die Ortung sah die Drohne noch nicht",
  "tracking saw the drone last {n} s ago": "die Ortung sah die Drohne zuletzt vor {n} s",
  "tracking does not see the drone": "die Ortung sieht die Drohne nicht",
  "No word from the pilot for {n} s: {then}. STOP and Land are still sent.":
    "Seit {n} s nichts vom Autopiloten: {then}. STOP und Landen werden weiter gesendet.",
  "No word from the drone for {n} s: {then}. STOP and Land are still sent.":
    "Seit {n} s nichts von der Drohne: {then}. STOP und Landen werden weiter gesendet.",
  // STOP
  "The drone hovers and takes no orders until Resume is held":
    "Die Drohne schwebt und nimmt keine Befehle an, bis „Fortsetzen“ gehalten wird",
  "The drone takes no orders until Resume is held":
    "Die Drohne nimmt keine Befehle an, bis „Fortsetzen“ gehalten wird",
  "its pilot is not heard; the next one is stopped, too":
    "der Autopilot schweigt; auch der nächste wird angehalten",
  "sent, the pilot has not confirmed it yet": "gesendet, noch nicht bestätigt",
  "the pilot has not confirmed it: it is sent again and again":
    "nicht bestätigt: STOP wird immer wieder gesendet",
  "STOP was not accepted": "STOP wurde nicht angenommen",
  "STOP did not arrive: no contact with the server":
    "STOP kam nicht an: keine Verbindung zum Server",
  // what happens without contact
  "it hovers until what is wrong is over, and lands by itself if that lasts":
    "sie schwebt, bis die Störung vorbei ist, und landet von selbst, wenn sie andauert",
  "it goes on coming home for safety, and lands":
    "sie kommt zur Sicherheit weiter zurück und landet",
  "it hovers where it is until somebody resumes, and lands by itself when charge or time run out":
    "sie schwebt an Ort und Stelle, bis jemand fortsetzt, und landet von selbst, wenn Akku " +
      "oder Zeit zu Ende gehen",
  "it goes on landing where it is": "sie landet weiter, wo sie ist",
  "it goes on sinking to the floor where it is": "sie sinkt weiter zum Boden, wo sie ist",
  "its motors are being cut: it falls": "ihre Motoren werden abgeschaltet: sie fällt",
  "it stays on the ground: nothing moves it without a fresh order":
    "sie bleibt am Boden: ohne neuen Befehl bewegt sie nichts",
  "nobody has told yet what the drone does": "noch ist nicht bekannt, was die Drohne tut",
  "the drone was on the ground when it was last heard; without a pilot nothing moves it":
    "die Drohne war zuletzt am Boden; ohne Autopilot bewegt sie nichts",
  ["it was in the air when it was last heard; landing is asked on, and a drone that hears " +
    "nobody brakes and lands by itself"]:
    "sie war zuletzt in der Luft; Landen wird weiter verlangt, und eine Drohne ohne " +
      "Verbindung bremst und landet von selbst",
  ["if the pilot has ended, the drone brakes and lands by itself within seconds; if only its " +
    "word is lost, {then}"]:
    "ist der Autopilot beendet, bremst und landet die Drohne in Sekunden von selbst; fehlt " +
      "nur seine Nachricht, gilt: {then}",
  "it goes on taking off, flies on to {goal}, then comes home and lands by itself within {n} s":
    "sie startet weiter, fliegt zu {goal}, kommt dann binnen {n} s von selbst zurück und landet",
  "it goes on taking off, hovers, then comes home and lands by itself within {n} s":
    "sie startet weiter, schwebt, kommt dann binnen {n} s von selbst zurück und landet",
  "it flies on to {goal}, then comes home and lands by itself within {n} s":
    "sie fliegt weiter zu {goal}, kommt dann binnen {n} s von selbst zurück und landet",
  "it looks to the end, then comes home and lands by itself":
    "sie sieht zu Ende nach, kommt dann von selbst zurück und landet",
  "it flies on home and lands by itself": "sie fliegt weiter zurück und landet von selbst",
  "it goes on landing": "sie landet weiter",
  "it hovers where it is, then comes home and lands by itself within {n} s":
    "sie schwebt an Ort und Stelle, kommt dann binnen {n} s von selbst zurück und landet",
  // why it may not take off, and the mend
  "no contact with the pilot": "keine Verbindung zum Autopiloten",
  "it is started again by itself: wait, or see its log in the run's folder":
    "er startet von selbst neu: warten, oder sein Protokoll im Ordner des Laufs ansehen",
  "the drone is already flying": "die Drohne fliegt schon",
  "The drone is already flying.": "Die Drohne fliegt schon.",
  "the checks before a take-off are not in yet": "die Prüfungen vor dem Start fehlen noch",
  "they come within seconds": "sie kommen in Sekunden",
  "the drone does not answer": "die Drohne antwortet nicht",
  "switch it on, join its Wi-Fi, and see `housefly doctor`":
    "einschalten, mit ihrem WLAN verbinden und `housefly doctor` ansehen",
  "its motors are cut": "ihre Motoren sind aus",
  "see that nobody is near and that it is whole, then hold Reset":
    "prüfen, dass niemand nahe und sie heil ist, dann „Zurücksetzen“ halten",
  "STOP is latched": "STOP ist gesetzt",
  "hold Resume when all is well": "„Fortsetzen“ halten, wenn alles in Ordnung ist",
  "look at the tracking system: is it running, does it stream the body under this name?":
    "die Ortung ansehen: Läuft sie, sendet sie den Körper unter diesem Namen?",
  "it stands under, on or in {thing}": "sie steht unter, auf oder in {thing}",
  "carry it to its pad": "zum Landeplatz tragen",
  "{why} ({found})": "{why} ({found})",
  "{why}; {more}": "{why}; {more}",
  "{why}: {more}": "{why}: {more}",
  // why an order would come to nothing
  "Motors are cut: hold Reset first.": "Motoren sind aus: erst „Zurücksetzen“ halten.",
  "Stopped: hold Resume first.": "Angehalten: erst „Fortsetzen“ halten.",
  "The drone does not answer yet.": "Die Drohne antwortet noch nicht.",
  "The drone is on the ground.": "Die Drohne ist am Boden.",
  "Only after STOP.": "Nur nach STOP.",
  "Not ready: {why}.": "Nicht bereit: {why}.",
  "Not now: {why}.": "Jetzt nicht: {why}.",
  "it comes home for safety": "sie kommt zur Sicherheit zurück",
  "it lands for safety": "sie landet zur Sicherheit",
  "its motors are being cut": "ihre Motoren werden abgeschaltet",
  // rules of safety
  "{why}: landing": "{why}: sie landet",
  "{why}: coming home": "{why}: sie kommt zurück",
  "{why}: slowly": "{why}: langsam",
  "{why}: the drone holds itself": "{why}: die Drohne hält sich selbst",
  "{why} (limit {n} s)": "{why} (Grenze {n} s)",
  "{why} (limit {d} m)": "{why} (Grenze {d} m)",
  "{why} (limit {d} m/s)": "{why} (Grenze {d} m/s)",
  "{why} (limit {n})": "{why} (Grenze {n})",
  "motors are being cut by order": "Motoren werden auf Befehl abgeschaltet",
  "the motors are cut: reset when nobody is near":
    "die Motoren sind aus: zurücksetzen, wenn niemand nahe ist",
  "on the floor for {n} s with its motors running: cutting them":
    "seit {n} s am Boden mit laufenden Motoren: Abschalten",
  "told to land for {n} s (limit {m} s) and still up: sinking by our own setpoint":
    "seit {n} s soll sie landen (Grenze {m} s) und ist noch oben: Sinken nach eigener Vorgabe",
  "the drone is silent for {n} s": "die Drohne schweigt seit {n} s",
  "people may be unseen: a sensor that looks for them is not heard yet":
    "Personen bleiben vielleicht ungesehen: von einem Sensor für sie kam noch nichts",
  "the drone has not confirmed its limits for {n} s":
    "die Drohne hat ihre Grenzwerte seit {n} s nicht bestätigt",
  "the drone has not confirmed its limits": "die Drohne hat ihre Grenzwerte nicht bestätigt",
  "battery {p}% is below {q}%": "Akku {p} % unter {q} %",
  "the battery lost {p}% in {n} s (limit {q}%)": "der Akku verlor {p} % in {n} s (Grenze {q} %)",
  "in the air for {n} s, as long as the charge at take-off allows (limits.flight_time {m} s)":
    "seit {n} s in der Luft, so lange die Ladung beim Start erlaubt (limits.flight_time {m} s)",
  "the pilot ran {n} s late": "der Autopilot war {n} s zu spät",
  "held for {n} of the last {m} s": "{n} der letzten {m} s gehalten",
  "STOP: hovering until resumed": "STOP: schwebt bis zum Fortsetzen",
  "battery {p}%, the way home ({n} s) needs {q}%": "Akku {p} %, der Heimweg ({n} s) braucht {q} %",
  "{n} s of flight left by the clock, the way home needs {m} s":
    "nach der Uhr noch {n} s Flug, der Heimweg braucht {m} s",
  "the pilot runs more than {n} s late": "der Autopilot ist mehr als {n} s zu spät",
  "commands reach the drone late or not at all":
    "Befehle erreichen die Drohne verspätet oder gar nicht",
  "the pilot is often late ({k} times within {n} s)":
    "der Autopilot ist oft zu spät ({k}-mal in {n} s)",
  "battery {p}%: it turns home at {q}%": "Akku {p} %: bei {q} % kehrt sie um",
  "the battery has shown {p}% for {n} s (limit {m} s): flying by the clock, {k} s left":
    "der Akku zeigt seit {n} s {p} % (Grenze {m} s): Flug nach der Uhr, noch {k} s",
  "tracking lost for {n} s": "Ortung seit {n} s verloren",
  "tracking has not shown the drone yet": "die Ortung zeigte die Drohne noch nicht",
  "poses disagree with the drone for {n} s":
    "die Ortung passt seit {n} s nicht zur Bewegung der Drohne",
  "the drone does not tell how it moves: tracking is not checked":
    "die Drohne meldet ihre Bewegung nicht: Die Ortung ist ungeprüft",
  "tracking has left the drone's own way by {d} m":
    "die Ortung weicht {d} m vom eigenen Weg der Drohne ab",
  "the tracked body is turned by {n} degrees against the drone":
    "der geortete Körper ist {n} Grad gegen die Drohne verdreht",
  "tracking is the mirror image of how the drone moves":
    "die Ortung ist das Spiegelbild der Bewegung",
  "the tracked height rose by {d} m (limit {m} m) without a step of the floor":
    "die geortete Höhe stieg um {d} m (Grenze {m} m) ohne Stufe im Boden",
  "the tracked height is off by {d} m from the drone's own":
    "die geortete Höhe weicht {d} m von der eigenen der Drohne ab",
  "{why}, or something is below: slowly": "{why}, oder darunter ist etwas: langsam",
  "the drone stands, and tracking shows it {d} m from the floor (limit {m} m): it stays down":
    "die Drohne steht, doch die Ortung zeigt sie {d} m vom Boden (Grenze {m} m): sie bleibt " +
      "unten",
  "the drone stands, and tracking shows it moved by {d} m (limit {m} m): it stays down":
    "die Drohne steht, doch die Ortung zeigt sie um {d} m bewegt (Grenze {m} m): sie bleibt " +
      "unten",
  "poses are {n} s older than they say": "die Ortung ist {n} s älter als angegeben",
  "struck something, or tracking jumped: {d} m/s faster or slower at once (limit {m} m/s), landing":
    "angestoßen, oder die Ortung sprang: plötzlich {d} m/s anders (Grenze {m} m/s), sie landet",
  "struck something: a blow of {d} m/s^2 (limit {m} m/s^2), landing":
    "etwas getroffen: Stoß von {d} m/s² (Grenze {m} m/s²), sie landet",
  "{d} m above its height of {m} m": "{d} m über ihrer Höhe von {m} m",
  "{d} m below its height of {m} m": "{d} m unter ihrer Höhe von {m} m",
  "{why} for long (limit {d} m)": "{why}, schon lange (Grenze {d} m)",
  "more than {d} m outside the map": "mehr als {d} m außerhalb der Karte",
  "higher than {d} m": "höher als {d} m",
  "lower than {d} m": "tiefer als {d} m",
  "climbs at {d} m/s": "steigt mit {d} m/s",
  "leans {n} degrees otherwise than told": "neigt sich {n} Grad anders als befohlen",
  "leaned otherwise than told for {d} of the last {n} s":
    "neigte sich {d} der letzten {n} s anders als befohlen",
  "leans {n} degrees and does not move (limit {m}): stuck on something, landing":
    "neigt sich {n} Grad und bewegt sich nicht (Grenze {m}): hängt fest, sie landet",
  "{d} m from where it should be": "{d} m von der Sollposition",
  "{why}: held": "{why}: gehalten",
  "{d} m/s": "{d} m/s",
  "at most {d} m/s": "höchstens {d} m/s",
  "it stands still, by its own word": "sie steht nach eigener Angabe still",
  "it takes off and holds itself by that speed":
    "sie hebt ab und hält sich nach dieser Geschwindigkeit",
  "the drone says that it moves while it stands": "die Drohne meldet Bewegung, obwohl sie steht",
  "people may be unseen: a sensor that looks for them gave nothing usable for {n} s":
    "Personen werden vielleicht nicht gesehen: seit {n} s nichts Brauchbares von einem Sensor",
  "the drone does not see how it moves: it cannot hold itself":
    "die Drohne sieht ihre Bewegung nicht: sie kann sich nicht selbst halten",
  "{why}, and the drone's own speed is not believed: sinking level":
    "{why}, und der eigenen Geschwindigkeit der Drohne ist nicht zu trauen: sie sinkt waagerecht",
  ["look at its bottom camera and the floor below, " +
      "then switch it off and on"]:
    "Kamera unten und Boden darunter ansehen, dann aus- und einschalten",
  ["the drone's own speed is not what tracking sees and how it leans: it cannot hold itself, " +
      "landing by tracking"]:
    "die eigene Geschwindigkeit passt weder zur Ortung noch zur Neigung: Landung nach Ortung",
  "about to leave the map by {d} m": "verlässt gleich die Karte um {d} m",
  "flies at {d} m/s (limit {m} m/s)": "fliegt mit {d} m/s (Grenze {m} m/s)",
  "moves more than {d} m/s otherwise than told": "bewegt sich mehr als {d} m/s anders als befohlen",
  "stands {d} m above the floor (limit {m} m): on something":
    "steht {d} m über dem Boden (Grenze {m} m): auf etwas",
  "blown {d} m from where it took off (limit {m} m) and only {k} m up: cutting the motors":
    "{d} m vom Startort verweht (Grenze {m} m) und nur {k} m hoch: Motoren werden abgeschaltet",
  "blown along at {d} m/s (limit {m} m/s) and only {k} m above the floor: cutting the motors":
    "mit {d} m/s verweht (Grenze {m} m/s), nur {k} m über dem Boden: Motoren werden abgeschaltet",
  "blown {d} m from where it took off": "{d} m vom Startort verweht",
  "told {d} m/s and does not move": "soll {d} m/s fliegen und bewegt sich nicht",
  "turned {n} degrees while it took off": "hat sich beim Abheben um {n} Grad gedreht",
  "blown about: {d} m/s off the wanted velocity for {n} s":
    "Böen: seit {n} s {d} m/s neben der Sollgeschwindigkeit",
  "the command was not a number": "der Befehl war keine Zahl",
  "nothing holds the drone back any more": "nichts hält die Drohne mehr zurück",
  // checks before a take-off
  "the drone answers": "die Drohne antwortet",
  "last {n} s ago": "zuletzt vor {n} s",
  "never": "nie",
  "at most {n} s ago": "höchstens vor {n} s",
  "a drone that is not heard cannot be stopped":
    "eine Drohne ohne Verbindung lässt sich nicht anhalten",
  "it stands, by its own word": "sie steht, sagt sie selbst",
  "the drone does not say that it stands": "die Drohne meldet nicht, dass sie steht",
  "landed": "gelandet",
  "flying": "fliegt",
  "taking off": "startet",
  "emergency": "Notaus",
  "unknown": "unbekannt",
  "only a drone that stands can take off": "nur eine stehende Drohne kann starten",
  "press RESET when it is in its emergency state and nobody is near":
    "„Zurücksetzen“ drücken, wenn sie im Notaus und niemand nahe ist",
  "it stands on its feet": "sie steht auf ihren Füßen",
  "the drone leans": "die Drohne steht schief",
  "{n} deg": "{n} Grad",
  "at most {n} deg": "höchstens {n} Grad",
  "a drone that leans takes off sideways": "schief startet sie zur Seite",
  "put it level on its pad": "eben auf den Landeplatz stellen",
  "it has confirmed its limits": "sie hat ihre Grenzwerte bestätigt",
  "confirmed": "bestätigt",
  "not yet": "noch nicht",
  "its own limits of tilt, height and speed hold when everything else fails":
    "ihre eigenen Grenzen für Neigung, Höhe und Tempo gelten, wenn alles andere versagt",
  "wait a few seconds, or switch it off and on": "einige Sekunden warten oder aus- und einschalten",
  "it complains about nothing": "sie meldet keine Störung",
  "the drone complains": "die Drohne meldet eine Störung",
  "nothing": "nichts",
  "it would land, or fall, in the middle of its flight":
    "sie würde mitten im Flug landen oder fallen",
  "look at propellers, motors and battery, then switch it off and on":
    "Propeller, Motoren und Akku ansehen, dann aus- und einschalten",
  "the battery is charged": "der Akku ist geladen",
  "the battery is too low": "der Akku ist zu leer",
  "{p}%": "{p} %",
  "at least {p}%, and more for a long way": "mindestens {p} %, für weite Wege mehr",
  "it has to come home, and to land": "sie muss zurückkommen und landen",
  "charge it, or change the battery": "laden oder Akku wechseln",
  "the battery's gauge moves": "die Akkuanzeige bewegt sich",
  "the battery's gauge stood still": "die Akkuanzeige stand still",
  "stuck at {p}%": "steht bei {p} %",
  "moving": "in Bewegung",
  "nobody knows how much charge is left": "niemand weiß, wie voll der Akku ist",
  "change the battery or restart the drone: take off once it shows another number":
    "Akku wechseln oder die Drohne neu starten: Start, sobald ein anderer Wert erscheint",
  "tracking sees it": "die Ortung sieht sie",
  "it flies by where tracking sees it": "sie fliegt nach der Ortung",
  ["look at the tracking system: is it running, does it stream the body under this name? if " +
    "it is only slow, housefly gains says which limits.pose_age_level it needs"]:
    "die Ortung ansehen: Läuft sie, sendet sie den Körper unter diesem Namen? Ist sie nur " +
      "langsam, nennt housefly gains das nötige limits.pose_age_level",
  "tracking leaves it where it stands": "die Ortung lässt sie, wo sie steht",
  "tracking moves the drone although it stands":
    "die Ortung bewegt die Drohne, obwohl sie steht",
  "moved by {d} m": "um {d} m bewegt",
  "at most {d} m": "höchstens {d} m",
  "tracking that drifts on the ground drifts in the air":
    "eine Ortung, die am Boden wandert, wandert auch in der Luft",
  "see whether another body has its name; lift it once to show where it is":
    "prüfen, ob ein anderer Körper ihren Namen hat; einmal anheben zeigt, wo sie ist",
  "tracking has it where it stands": "die Ortung zeigt sie, wo sie steht",
  "tracking has the drone at another height": "die Ortung zeigt die Drohne in anderer Höhe",
  "{d} m": "{d} m",
  "within {d} m": "innerhalb {d} m",
  "a floor at another height is a room at another height":
    "ein Boden in anderer Höhe ist ein Raum in anderer Höhe",
  "set the tracking system's origin on the floor, and define the drone's body anew":
    "Ursprung der Ortung auf den Boden legen und den Körper der Drohne neu anlegen",
  "nobody has pressed STOP": "niemand hat STOP gedrückt",
  "pressed": "gedrückt",
  "not pressed": "nicht gedrückt",
  "STOP is latched until a person resumes": "STOP gilt, bis jemand fortsetzt",
  "press Resume when all is well": "„Fortsetzen“ drücken, wenn alles in Ordnung ist",
  "nobody and nothing is above or beside it": "niemand und nichts ist über oder neben ihr",
  "the way up is not free": "der Weg nach oben ist nicht frei",
  "clear": "frei",
  "{who} is too close": "{who} ist zu nah",
  "make room around the drone": "um die Drohne Platz machen",
  "it climbs straight up from where it stands": "sie steigt von ihrem Platz gerade nach oben",
  "its settings and sensors are as they should be": "Einstellungen und Sensoren sind in Ordnung",
  "a setting or sensor of the drone is wrong":
    "eine Einstellung oder ein Sensor der Drohne stimmt nicht",
  "yes": "ja",
  "it may fly otherwise than planned": "sie fliegt vielleicht anders als geplant",
  "see the drone's page of the manual": "die Seite der Drohne im Handbuch ansehen",
  "tracking has seen it on its pad": "die Ortung hat sie auf dem Landeplatz gesehen",
  "tracking has not seen the drone on its pad":
    "die Ortung hat die Drohne nicht auf dem Landeplatz gesehen",
  "{d} m from it, turned by {n} deg": "{d} m davon entfernt, um {n}° gedreht",
  "once within {d} m and {n} deg of it": "einmal höchstens {d} m und {n}° davon",
  "where tracking and map disagree, walls are not where they seem":
    "wo Ortung und Karte nicht übereinstimmen, sind Wände nicht, wo sie scheinen",
  "put it on its pad, its nose along it; if it stands so: `housefly preflight --frames`":
    "auf den Landeplatz stellen, die Nase in dessen Richtung; steht sie so: " +
      "`housefly preflight --frames`",
  "it stands on its pad": "sie steht auf dem Landeplatz",
  "the drone is not on its pad": "die Drohne steht nicht auf dem Landeplatz",
  "{d} m from it": "{d} m davon entfernt",
  "if it does stand there, tracking and map disagree, and walls are not where they seem":
    "steht sie doch dort, passen Ortung und Karte nicht, und Wände sind nicht, wo sie scheinen",
  "put it on its pad; if it is there, compare the tracking system's origin with the map":
    "auf den Landeplatz stellen; steht sie dort, den Ursprung der Ortung mit der Karte " +
      "vergleichen",
  "it has what others have": "sie hat, was andere haben",
  "the drone lacks what others have": "der Drohne fehlt, was andere haben",
  "steering by tilt": "Steuern durch Neigen",
  "a camera": "eine Kamera",
  "a hover of its own": "eigenes Schweben",
  "its own height": "eigene Höhe",
  "its own velocity": "eigene Geschwindigkeit",
  "its own attitude": "eigene Lage",
  "rules that need it do not count, and where tracking fails it sinks and lands":
    "Regeln, die das brauchen, gelten nicht; fällt die Ortung aus, sinkt und landet sie",
  "fly it where tracking is sure, and keep people away":
    "nur fliegen, wo die Ortung sicher ist, und niemanden in die Nähe lassen",
  "a sensor sees people without markers": "ein Sensor sieht Personen ohne Marker",
  "people without markers are unseen": "Personen ohne Marker sieht sie nicht",
  "no sensor": "kein Sensor",
  "it stops for people, and makes way, only where a sensor sees them":
    "nur für Personen, die ein Sensor sieht, hält sie und weicht aus",
  "nothing usable for {n} s": "seit {n} s nichts Brauchbares",
  "not heard yet": "noch nichts gehört",
  "heard within {n} s": "vor höchstens {n} s gehört",
  "see `housefly sensors`: is each one on, in this network and uncovered?":
    "`housefly sensors` ansehen: ist jeder an, in diesem Netz und unverdeckt?",
  "keep people out of the room, or add a scanner or a depth camera to the site":
    "niemanden in den Raum lassen, oder Scanner oder Tiefenkamera ergänzen",
  "the last frame check found nothing wrong": "die letzte Achsenprüfung fand keinen Fehler",
  "the last frame check found tracking wrong": "die letzte Achsenprüfung fand die Ortung falsch",
  "nothing known": "nichts bekannt",
  "it would fly where it should not, and land or strike something":
    "sie flöge an falsche Orte und landete oder stieße an",
  "mend it as the check said, and check again: `housefly preflight --frames`":
    "wie von der Prüfung gesagt beheben und neu prüfen: `housefly preflight --frames`",
  "frames checked": "Achsen geprüft",
  "frames not checked": "Achsen nicht geprüft",
  "since [tracking] was changed": "seit [tracking] geändert wurde",
  "before the site's [tracking] was changed": "bevor [tracking] geändert wurde",
  "not needed: the room is simulated": "nicht nötig: der Raum ist simuliert",
  "found wrong": "falsch",
  "checked": "geprüft",
  "mirrored, turned or shifted axes are noticed only after the drone has moved":
    "gespiegelte, gedrehte oder verschobene Achsen fallen erst nach einer Bewegung auf",
  "carry the drone once, two minutes: `housefly preflight --frames`":
    "die Drohne einmal umhertragen, zwei Minuten: `housefly preflight --frames`",
  "Watching the room": "Der Raum wird beobachtet",
  "Waiting for tracking": "Warte auf die Ortung",
  "no drone": "keine Drohne",
  "this room has no drone": "dieser Raum hat keine Drohne",
  "This room has no drone.": "Dieser Raum hat keine Drohne.",
  "this machine keeps up": "dieser Rechner kommt mit",
  "this computer is too busy": "dieser Rechner hat zu viel zu tun",
  "load {n} on {k} cores": "Last {n} auf {k} Kernen",
  "load {n} on {k} core": "Last {n} auf {k} Kern",
  "a load below {n}": "eine Last unter {n}",
  "what comes late is refused, as if it had not come":
    "was zu spät kommt, wird verworfen, als wäre es nie gekommen",
  "end other programs; the simulated picture costs most (twin.video = false)":
    "andere Programme beenden; das simulierte Bild kostet am meisten (twin.video = false)",
  "there is room on the disk": "auf der Platte ist Platz",
  "a disk is nearly full": "eine Platte ist fast voll",
  "{p}% free at {name}": "{p} % frei auf {name}",
  "at least {p}% free, or {n} GB": "mindestens {p} % frei, oder {n} GB",
  "what happens in the flight could not be kept":
    "was im Flug geschieht, ließe sich nicht aufbewahren",
  "delete old flights, or move them to another disk":
    "alte Flüge löschen oder auf eine andere Platte verschieben",
  "the disk can be written to": "auf die Platte lässt sich schreiben",
  "a disk cannot be written to": "auf eine Platte lässt sich nicht schreiben",
  "written a moment ago": "eben geschrieben",
  "a file can be written": "eine Datei lässt sich schreiben",
  "mount the disk for writing again, or let this user write there":
    "die Platte wieder zum Schreiben einhängen oder diesen Benutzer dort schreiben lassen",
  "nothing here sees people: no scanner, no depth camera":
    "hier sieht nichts Personen: kein Scanner, keine Tiefenkamera",
  // why there is no way
  "there is no free way from {name} to {place}": "kein freier Weg von {name} nach {place}",
  // what was refused
  "{asked} refused: {why}": "{asked} abgelehnt: {why}",
  "take off": "Starten",
  "land": "Landen",
  "hover": "Schweben",
  "resume": "Fortsetzen",
  "reset": "Zurücksetzen",
  "cut": "Motoren aus",
  "go": "Hinfliegen",
  "service": "Nachsehen",
  "the order is {n} s old; orders expire after {m} s":
    "der Befehl ist {n} s alt; Befehle verfallen nach {m} s",
  "there is no emergency to leave: the drone is {what}":
    "kein Notaus aufzuheben; Zustand der Drohne: {what}",
  "STOP is latched: resume first": "STOP ist gesetzt: erst fortsetzen",
  "the drone is being landed for safety": "die Drohne wird zur Sicherheit gelandet",
  "the drone is coming home for safety": "die Drohne kommt zur Sicherheit zurück",
  "the drone is not ready: {what}": "die Drohne ist nicht bereit: {what}",
  "the drone has not confirmed its limits yet: wait, or switch it off and on":
    "die Drohne hat ihre Grenzwerte noch nicht bestätigt: warten oder aus- und einschalten",
  ["tracking sees the drone {d} m from where it stands (limit {m} m): check the tracking " +
    "system's origin and the drone's body"]:
    "die Ortung sieht die Drohne {d} m neben ihrem Stand (Grenze {m} m): Ursprung der Ortung " +
      "und Körper der Drohne prüfen",
  "the battery is too low: {p}%, take-off needs {q}%":
    "der Akku ist zu leer: {p} %, der Start braucht {q} %",
  ["tracking shows the drone as it was {n} s ago (limits.pose_age_level: {m} s); housefly " +
    "gains says which limit slow tracking needs"]:
    "die Ortung zeigt die Drohne von vor {n} s (limits.pose_age_level: {m} s); housefly gains " +
      "nennt die nötige Grenze",
  "{why}: {found}, must be {limit}; {mend}": "{why}: {found}, nötig: {limit}; {mend}",
  "someone else flies the drone: hold the button to take over":
    "jemand anderes fliegt: zum Übernehmen die Taste halten",
  "you do not have control": "Sie steuern nicht",
  "this session is over": "diese Sitzung ist beendet",
  "too many commands at once: wait a moment": "zu viele Befehle auf einmal: kurz warten",
  "that viewer is not here any more, or may not fly":
    "jener Zuschauer ist nicht mehr da oder darf nicht fliegen",
  "the order needs either a place or a goal": "der Befehl braucht einen Ort oder ein Ziel",
  "the room is not known yet": "der Raum ist noch nicht bekannt",
  "the goal is outside the room": "das Ziel liegt außerhalb des Raums",
  "no contact with the server": "keine Verbindung zum Server",
  "the line to the server broke": "die Verbindung zum Server brach ab",
  "with your role clips can be watched, not taken away together":
    "mit Ihrer Rolle lassen sich Clips ansehen, nicht gemeinsam speichern",
  // the room and the tasks
  "bell pressed": "Türklingel gedrückt",
  "bell": "Türklingel",
  "person present": "Person anwesend",
  "person walking": "Person geht",
  "person standing": "Person steht",
  "person sitting": "Person sitzt",
  "person lying": "Person liegt",
  "person fallen": "Person gestürzt",
  "present": "anwesend",
  "walking": "geht",
  "standing": "steht",
  "sitting": "sitzt",
  "lying": "liegt",
  "fallen": "gestürzt",
  "bed occupied": "Bett belegt",
  "appliance on": "Gerät an",
  "contact open": "Tür offen",
  "no": "nein",
  "ignore": "nicht beachten",
  "not now": "jetzt nicht",
  "landing": "landet",
  "{why}: it holds itself": "{why}: sie hält sich selbst",
  "The drone flies somewhere: press Hover first.":
    "Die Drohne ist unterwegs: erst „Schweben“ drücken.",
  "in the air the drone keeps the map that it took off with: land first":
    "in der Luft behält die Drohne die Karte vom Start: erst landen",
  "nobody knows whether the drone flies": "niemand weiß, ob die Drohne fliegt",
  "a task is under way: wait for its end, or end it":
    "eine Aufgabe läuft: ihr Ende abwarten oder sie beenden",
  "the drone has this version already": "die Drohne hat diese Fassung schon",
  "that is being done already": "das geschieht schon",
  "this run is recorded, and a recording has one map: start anew":
    "dieser Lauf wird aufgezeichnet, mit nur einer Karte: neu starten",
  "the camera records only in flight": "die Kamera nimmt nur im Flug auf",
  "that picture is not in memory any more": "dieses Bild ist nicht mehr gespeichert",
  "the pilot starts again with the new map; order it anew in a moment":
    "der Autopilot startet mit der neuen Karte neu; gleich noch einmal befehlen",
  "{who} starts the pilot again, so that the drone has the newest places and zones":
    "{who} startet den Autopiloten neu, damit die Drohne die neuesten Orte und Zonen hat",
  // moving by hand, and complaints of the drone
  "Moving by hand is switched off here.": "Bewegen von Hand ist hier ausgeschaltet.",
  "A task flies the drone: press Hover first.":
    "Eine Aufgabe fliegt die Drohne: erst „Schweben“ drücken.",
  "moving by hand is switched off here (limits.nudge_speed)":
    "Bewegen von Hand ist hier ausgeschaltet (limits.nudge_speed)",
  "moving by hand needs map.planner = \"space\", and mode default":
    "Bewegen von Hand braucht map.planner = \"space\" und den Modus default",
  "a maneuver flies the drone": "ein Manöver fliegt die Drohne",
  "moving by hand is asked for by nudges, each with a velocity":
    "Bewegen von Hand geht nur mit den Tasten dafür",
  "the line is slow: this came {n} s late": "die Verbindung ist langsam: dies kam {n} s zu spät",
  "move by hand": "Bewegen von Hand",
  "motors problem": "Motorstörung",
  "software fault": "Softwarefehler",
  "motors cut out": "Motoren ausgefallen",
  "battery low": "Akku schwach",
  "tilted too far": "zu stark geneigt",
  "sensor board silent": "Sensorplatine schweigt",
  "flight timer elapsed": "Flugzeit abgelaufen",
  "too much wind": "zu viel Wind",
  "ultrasound deaf": "Ultraschall taub",
  "the room's memory does not answer": "das Gedächtnis des Raums antwortet nicht",
  // what the pilot tells
  "0 to {n} s": "0 bis {n} s",
  "a number is not finite": "eine Zahl ist nicht endlich",
  "a wall may be near": "eine Wand könnte nahe sein",
  "a wall or furniture is ahead": "voraus sind Wand oder Möbel",
  "a way has become free that is {n} s faster: taking it":
    "ein um {n} s schnellerer Weg wurde frei: sie nimmt ihn",
  "above the pad, landing": "über dem Landeplatz, sie landet",
  "accept orders again": "nimmt wieder Befehle an",
  "an obstacle of {who} is refused: {why}": "ein Hindernis von {who} wird abgelehnt: {why}",
  "an order to stop or land came before it was taken":
    "vorher kam ein Befehl zum Anhalten oder Landen",
  "arrived": "angekommen",
  "arrived, looking": "angekommen, sie sieht nach",
  "at most {d} m/s, and only by nudge": "höchstens {d} m/s, und nur beim Bewegen von Hand",
  "at most {n} printable letters": "höchstens {n} druckbare Zeichen",
  "came to rest off its course: going on from there":
    "kam neben ihrem Kurs zur Ruhe: weiter von dort",
  "coming home for safety": "kommt zur Sicherheit zurück",
  "coordinates of at most {d} m": "Koordinaten bis {d} m",
  "cut the motors": "Motoren abschalten",
  "do it from here": "von hier aus",
  "do it once in the air": "sobald sie in der Luft ist",
  "drone lost our commands": "Drohne empfing keine Befehle",
  "emergency landing by the user": "Notlandung durch Benutzer",
  "emergency left": "Notaus aufgehoben",
  "flying to goal": "fliegt zum Ziel",
  "furniture or a wall stands below or beside it":
    "darunter oder daneben sind Möbel oder eine Wand",
  "furniture stands below": "darunter stehen Möbel",
  "goal is not a position in a room": "goal ist kein Ort in einem Raum",
  "holding": "hält",
  "holding here: {why}": "bleibt hier: {why}",
  "hover, and accept nothing that moves until RESUME":
    "schwebt und nimmt bis „Fortsetzen“ keine Flugbefehle an",
  "id is not a name": "id ist kein Name",
  "idle": "in Ruhe",
  "it does not agree with the drone's own motion": "sie passt nicht zur Eigenbewegung der Drohne",
  "it flies slowly here by order": "hier soll sie langsam fliegen",
  "it is faster than {d} m/s": "es ist schneller als {d} m/s",
  "it is too far from where the drone can be": "sie ist zu weit von dort, wo die Drohne sein kann",
  "it is too old": "sie ist zu alt",
  "it lies far outside the map": "es liegt weit außerhalb der Karte",
  "it names neither a place nor a goal": "er nennt weder Ort noch Ziel",
  ["it says that the drone moved {d} m while it lay still: is it another body? Lift the " +
    "drone to show where it is"]:
    "sie zeigt {d} m Bewegung, obwohl die Drohne still lag: Ist es ein anderer Körper? " +
      "Drohne anheben, um zu zeigen, wo sie ist",
  "it stays the same to the last bit while the drone flies":
    "sie bleibt bis aufs letzte Bit gleich, obwohl die Drohne fliegt",
  "it was seen in the future": "es wurde in der Zukunft gesehen",
  "its confidence does not lie between 0 and 1": "seine Sicherheit liegt nicht zwischen 0 und 1",
  "its own motion is in doubt": "ihre Eigenbewegung ist unsicher",
  "its size makes no sense (at most {d} m)": "seine Größe ist unmöglich (höchstens {d} m)",
  "its sonar shows something everywhere": "ihr Ultraschall zeigt überall etwas",
  "its stamp is not newer than the last one": "ihr Zeitstempel ist nicht neuer als der letzte",
  "its stamp lies in the future": "ihr Zeitstempel liegt in der Zukunft",
  "land here": "hier landen",
  "landing all the same: {why}": "landet trotzdem: {why}",
  "landing for safety": "landet zur Sicherheit",
  "landing here": "landet hier",
  "landing is not acknowledged after {n} s: still asking":
    "Landung nach {n} s nicht bestätigt: wird weiter verlangt",
  "landing {d} m beside": "landet {d} m daneben",
  "leave the emergency state": "Notaus verlassen",
  "look_at is not a position in a room": "look_at ist kein Ort in einem Raum",
  "look_s is wrong": "look_s ist falsch",
  "looked long enough, coming home": "lange genug nachgesehen, kommt zurück",
  "looking": "sieht nach",
  "looking below": "prüft, was darunter ist",
  "motor cut": "Abschalten der Motoren",
  "motors are cut": "Motoren sind aus",
  "moved by hand": "von Hand bewegt",
  "moved by hand by {who}": "von {who} von Hand bewegt",
  "moved by hand no longer": "nicht mehr von Hand bewegt",
  "moved by hand: {why}": "von Hand bewegt: {why}",
  "moving aside": "weicht zur Seite aus",
  "moving {d} m aside by the drone's own motion, to land":
    "geht zum Landen {d} m zur Seite, nach eigener Bewegung",
  "no clear place to land within 2 m: holding by the drone's own motion":
    "kein freier Landeplatz im Umkreis von 2 m: hält sich nach eigener Bewegung",
  "no clear place to land within 2 m: waiting in the air":
    "kein freier Landeplatz im Umkreis von 2 m: wartet in der Luft",
  "no order for {n} s: coming home": "{n} s lang kein Befehl: kommt zurück",
  "no place called {name}: did you mean {place}? known places: {places}":
    "kein Ort namens {name}: meinten Sie {place}? Bekannte Orte: {places}",
  "no place called {name}; known places: {places}":
    "kein Ort namens {name}; bekannte Orte: {places}",
  "no way home, landing here: {why}": "kein Weg nach Hause, landet hier: {why}",
  "no way leads from home to {end} {place}": "von zu Hause führt kein Weg hierher: {end} {place}",
  "no way of flying there keeps the limits of the drone":
    "kein Flug dorthin hält die Grenzen der Drohne ein",
  "nobody comes near: going back": "niemand kommt näher: kehrt an ihren Ort zurück",
  "not all its numbers are finite": "nicht alle seine Zahlen sind endlich",
  "not landing: {why}": "landet nicht: {why}",
  "not landing: {why}. Press Land to land here all the same":
    "landet nicht: {why}. „Landen“ drücken, um trotzdem hier zu landen",
  "nothing can be written at {name} ({why})": "auf {name} lässt sich nichts schreiben ({why})",
  "nudge": "Bewegen von Hand",
  "obstacle refused: {why}": "Hindernis abgelehnt: {why}",
  "on the ground": "am Boden",
  "ordered to": "auf Befehl",
  "place is not a name": "place ist kein Name",
  "returning": "kommt zurück",
  "sender is not a name": "sender ist kein Name",
  "somebody": "jemand",
  "something": "etwas",
  "the simulated room": "der simulierte Raum",
  "somebody is asked first": "erst wird jemand gefragt",
  "its task is asked for": "seine Aufgabe wird verlangt",
  "something hangs over the drone: carry it to where the air above is free":
    "über der Drohne hängt etwas: dorthin tragen, wo die Luft darüber frei ist",
  "something was found below here": "hier wurde darunter etwas gefunden",
  "something {d} m high seems to lie on the pad: is it clear?":
    "auf dem Landeplatz scheint etwas {d} m Hohes zu liegen: Ist er frei?",
  "something {d} m high seems to stand below": "darunter scheint etwas {d} m Hohes zu stehen",
  "stands {d} m above the floor: on something": "steht {d} m über dem Boden: auf etwas",
  "stands {d} m above where it took off: on something":
    "steht {d} m höher als beim Start: auf etwas",
  "stay here": "bleibt hier",
  "stop": "Anhalten",
  "take off, then do it": "startet, dann",
  "the battery is too low: {p}%, there and back ({n} s) needs {q}%; charge it":
    "der Akku ist zu leer: {p} %, hin und zurück ({n} s) braucht {q} %; laden",
  "the drone did not acknowledge the {what}": "nicht von der Drohne bestätigt: {what}",
  "the drone does not tell how it moves": "die Drohne meldet ihre Bewegung nicht",
  "the drone flies already": "die Drohne fliegt schon",
  "the drone flies although its motors were cut: landing":
    "die Drohne fliegt, obwohl ihre Motoren aus waren: sie landet",
  "the drone flies somewhere: press Hover first":
    "die Drohne ist unterwegs: erst „Schweben“ drücken",
  "the drone is in its emergency state: motors off": "die Drohne ist im Notaus: Motoren aus",
  "the drone is in the air without an order: holding":
    "die Drohne ist ohne Befehl in der Luft: sie hält",
  "the drone is landing": "die Drohne landet",
  "the drone is on the ground": "die Drohne ist am Boden",
  "the drone is taking off already": "die Drohne startet schon",
  "the drone is too fast to turn there: let it stop first":
    "die Drohne ist zu schnell, um dorthin abzubiegen: erst anhalten lassen",
  "the drone lands by itself": "die Drohne landet von selbst",
  "the drone says: {what}": "die Drohne meldet: {what}",
  "the drone says: {what}; landing": "die Drohne meldet: {what}; sie landet",
  "the drone stands in a no-fly area: carry it out":
    "die Drohne steht in einer Verbotszone: hinaustragen",
  "the drone was moved on the ground: tracking starts anew":
    "die Drohne wurde am Boden bewegt: die Ortung beginnt neu",
  "the drone's sonar shows something everywhere: landing by the tracked height":
    "der Ultraschall zeigt überall etwas: Landung nach der Höhe der Ortung",
  "the end of where it may fly is ahead": "voraus endet der erlaubte Bereich",
  "the goal": "das Ziel",
  "the last place of {who} is no longer kept clear":
    "der letzte Ort von {who} wird nicht mehr freigehalten",
  "the order's {what}; allowed: {limit}": "Befehl: {what}; erlaubt: {limit}",
  "the orientation is not a unit quaternion": "die Lage ist kein Einheitsquaternion",
  "the pad of {who} is there": "dort ist der Landeplatz von {who}",
  "the pilot failed ({name}): landing": "der Autopilot ist ausgefallen ({name}): sie landet",
  "the start": "der Start",
  "the way is free: going on": "der Weg ist frei: weiter",
  "the way stays blocked": "der Weg bleibt versperrt",
  "there are more than {n} at once": "es sind mehr als {n} zugleich",
  "there is a way: going on": "es gibt einen Weg: weiter",
  "there is nowhere to go": "es gibt kein Ziel",
  "too many orders in a second": "zu viele Befehle in einer Sekunde",
  "took too long": "dauerte zu lange",
  "tracking is believed in part, {n} of the last {m} poses are not: {why}":
    "die Ortung ist nur zum Teil glaubwürdig, {n} der letzten {m} Posen nicht: {why}",
  "tracking is not believed since {n} s: {why}": "die Ortung ist seit {n} s unglaubwürdig: {why}",
  "velocity is wrong": "velocity ist falsch",
  "waiting here: {why}": "wartet hier: {why}",
  "{asked} by {who}: {what}": "{asked}, von {who}: {what}",
  "{asked} {place}": "{asked} {place}",
  "{asked}: {what}": "{asked}: {what}",
  "{end} is not a position: {place}": "{end} ist kein Ort: {place}",
  "{end} {place} is too close to an obstacle": "{end} {place} ist einem Hindernis zu nah",
  "{end} {place} is too close to an obstacle ({d} m)":
    "{end} {place} ist einem Hindernis zu nah ({d} m)",
  "{end} {place} is too close to an obstacle: {d} m from the hull, which keeps {m} m":
    "{end} {place} ist einem Hindernis zu nah: {d} m vom Rumpf, nötig sind {m} m",
  "{end} {place} lies in a no-fly area": "{end} {place} liegt in einer Verbotszone",
  "{end} {place} lies in an obstacle": "{end} {place} liegt in einem Hindernis",
  "{end} {place} lies outside the map": "{end} {place} liegt außerhalb der Karte",
  "{end} {place} lies outside the room": "{end} {place} liegt außerhalb des Raums",
  "{thing} is in the way, {d} m ahead": "{thing} ist im Weg, {d} m voraus",
  "{thing} is in the way: going around": "{thing} ist im Weg: sie fliegt herum",
  "{thing} is near": "{thing} ist nah",
  "{what} took too long": "zu lange: {what}",
  "{who} comes near": "{who} kommt näher",
  "{who} comes near and there is no room to make way":
    "{who} kommt näher, und zum Ausweichen ist kein Platz",
  "{who} comes near and there is no room to make way: landing here":
    "{who} kommt näher, und zum Ausweichen ist kein Platz: sie landet hier",
  "{who} comes near: making way": "{who} kommt näher: sie weicht aus",
  "{who} comes near: the take-off is given up": "{who} kommt näher: Start abgebrochen",
  "{who} flew and is not seen any more: its last place is kept clear":
    "{who} flog und ist nicht mehr zu sehen: ihr letzter Ort bleibt frei",
  "{who} gives too many orders: {n} were refused in a second (limit {m} a second)":
    "{who} gibt zu viele Befehle: {n} in einer Sekunde abgelehnt (Grenze {m} je Sekunde)",
  "{who} is below": "{who} ist darunter",
  "{who} walks into the way: going around": "{who} läuft in den Weg: sie fliegt herum",
  "{who} walks into the way: waiting": "{who} läuft in den Weg: sie wartet",
  "{who}: {why}": "{who}: {why}",
  "{why}, once it can: {what}": "{why}, sobald sie kann: {what}",
  "{why}, {d} ms late": "{why}, {d} ms zu spät",
  "{why}, {more}": "{why}, {more}",
  "{why}: landing here": "{why}: sie landet hier",
  "{why}: stopping": "{why}: sie hält an",
  "{why}: {found}, must be {limit}; likely cause: {cause} ({value}): {mend}":
    "{why}: {found}, nötig: {limit}; wohl weil: {cause} ({value}): {mend}",
  "{why}: {found}; {mend}": "{why}: {found}; {mend}",
  "{why}; nearest free place: ({x}, {y}) m": "{why}; nächster freier Ort: ({x}; {y}) m",
  "{why}; no way home, waiting here: {more}": "{why}; kein Weg nach Hause, wartet hier: {more}",
  "{why}; no way on, waiting here: {more}": "{why}; kein Weg weiter, wartet hier: {more}",
  // who is here, and who has control
  "a browser came in by {link}: {what}": "ein Browser kam herein über {link}: {what}",
  "another tab says hello on a socket of its own":
    "ein anderer Tab meldet sich mit eigener Verbindung",
  "it may do everything": "er darf alles",
  "it may fly": "er darf fliegen",
  "it may watch": "er darf zusehen",
  "it may watch and ask": "er darf zusehen und fragen",
  "no path could be asked for: {why}": "nach dem Weg ließ sich nicht fragen: {why}",
  "nobody has control: take it first": "niemand steuert: erst die Steuerung übernehmen",
  "say hello first": "erst anmelden",
  "the console was started again": "die Konsole wurde neu gestartet",
  "nobody knows what happened while the console was away":
    "niemand weiß, was geschah, während die Konsole fort war",
  "the link of the terminal": "den Link des Terminals",
  "the link that {who} made": "den Link von {who}",
  "the order to {asked} takes no place and no goal":
    "dieser Befehl braucht weder Ort noch Ziel: {asked}",
  "your role is {name}, and this needs {what}: ask who runs Housefly":
    "Ihre Rolle ist {name}, nötig ist {what}: den Betreiber von Housefly fragen",
  "{who} handed control to {name}": "{who} hat die Steuerung an {name} übergeben",
  "{who} has control": "{who} steuert",
  "{who} laid down control": "{who} hat die Steuerung abgegeben",
  "{who} may not fly any more and lost control":
    "{who} darf nicht mehr fliegen und steuert nicht mehr",
  "{who} saved places and zones": "{who} hat Orte und Zonen gespeichert",
  "{who} took control": "{who} hat die Steuerung übernommen",
  "{who} undid a change of places and zones":
    "{who} hat eine Änderung an Orten und Zonen zurückgenommen",
  "{who} was silent for {n} s and lost control: nobody has it now":
    "{who} war {n} s still und steuert nicht mehr: jetzt steuert niemand",
  "{who}: {what}, but the pilot is not heard": "{who}: {what}, doch der Autopilot schweigt",
  // services of the house
  "Look at a place or a thing": "Ort oder Ding ansehen",
  "Flies to where it is seen from, takes a picture and comes home.":
    "Fliegt zum Blickpunkt, macht ein Bild und kommt zurück.",
  "Where is something": "Wo ist etwas",
  "Says where the memory has it; when that is old or unsure, flies there and looks.":
    "Nennt den Ort aus dem Gedächtnis; ist er alt oder unsicher, sieht sie nach.",
  "Patrol": "Rundgang",
  "Looks at every place in turn, takes pictures and tells what changed since the last time.":
    "Sieht jeden Ort an, macht Bilder und meldet, was sich geändert hat.",
  "Night round": "Nachtrunde",
  "Looks after everybody and every place once, quietly; tells only what is wrong.":
    "Sieht leise einmal überall nach; meldet nur, was nicht stimmt.",
  "Look who is at the door": "Nachsehen, wer an der Tür ist",
  "Flies to the entrance, films whoever stands there and tells everybody.":
    "Fliegt zum Eingang, filmt, wer dort steht, und meldet es allen.",
  "Look around": "Umsehen",
  "Takes pictures in all directions, where the drone starts or at a place.":
    "Macht Bilder in alle Richtungen, am Startort oder an einem Ort.",
  "Fly to a point": "Zu einem Punkt fliegen",
  "Flies to a point, waits there and comes home.":
    "Fliegt zu einem Punkt, wartet dort und kommt zurück.",
  "Is everything all right?": "Ist alles in Ordnung?",
  "Tells how everybody is; looks after who may have fallen or left their bed at night.":
    "Sagt, wie es allen geht; sieht nach, wer gestürzt oder nachts aufgestanden ist.",
  "Inventory": "Bestand",
  "Tells what is in the cabinet and the refrigerator, and takes a picture of each.":
    "Sagt, was in Schrank und Kühlschrank ist, und macht von beiden ein Bild.",
  "Follow somebody": "Jemandem folgen",
  "Keeps a person in view for a while; looks for who is lost, then comes home.":
    "Behält eine Person eine Weile im Bild; sucht sie, kommt dann zurück.",
  "Find a lost thing": "Verlorenes suchen",
  "Looks where it most likely is, shows pictures and asks; tells what was not looked at.":
    "Sieht nach, wo es wohl ist, zeigt Bilder und fragt; sagt, was nicht angesehen wurde.",
  "Come to somebody": "Zu jemandem kommen",
  "Flies to a person, faces them and waits; goes home when told, or after a while.":
    "Fliegt zu einer Person, wendet sich ihr zu und wartet; kommt auf Wunsch oder nach " +
      "einer Weile zurück.",
  "what to look at": "was anzusehen ist",
  "how long to look": "wie lange hinsehen",
  "how long to look at each": "wie lange jeweils hinsehen",
  "where to look, in this order": "wo nachzusehen ist, in dieser Reihenfolge",
  "where to look, in this order; whole floor sees all of it":
    "wo nachzusehen ist, in dieser Reihenfolge; whole floor zeigt alles",
  "where visitors stand": "wo Besuch steht",
  "how long to hover there": "wie lange dort schweben",
  "how long to wait there": "wie lange dort warten",
  "for how long": "wie lange",
  "how many pictures": "wie viele Bilder",
  "a thing or a person": "ein Ding oder eine Person",
  "what is lost": "was fehlt",
  "one of them only": "nur eine Person davon",
  "when to fly there": "wann hinfliegen",
  "age that counts as stale": "ab wann es als alt gilt",
  "for an answer to each picture": "Wartezeit je Bild",
  "for all looks together": "für alles zusammen",
  "where; without one, above the pad": "wo; sonst über dem Landeplatz",
  "whom; anybody is whoever is nearest": "wen; anybody ist, wer am nächsten ist",
  "to whom; anybody is whoever is nearest": "zu wem; anybody ist, wer am nächsten ist",
  "what must be off at night": "was nachts aus sein muss",
  "names with commas between them": "Namen, mit Komma getrennt",
  "connected to {name}, but it is silent": "mit {name} verbunden, doch es kommt nichts",
  "connected to {name}, but no scans arrive":
    "mit {name} verbunden, doch es kommen keine Messungen",
  "connected to {name}, but nothing new arrives; is {what} live, not paused?":
    "mit {name} verbunden, doch es kommt nichts Neues; läuft {what}, ohne Pause?",
  "found in the air by a new driver: it only hovers and lands":
    "ein neuer Treiber fand sie in der Luft: sie schwebt nur und landet",
  "frames arrive from {name}, but their time stands still; is {what} paused?":
    "von {name} kommen Bilder, doch ihre Zeit steht; ist {what} angehalten?",
  "frames do not come from {name}; set tracking.address to {other}":
    "Daten kommen nicht von {name}; in tracking.address {other} eintragen",
  "is its unit millimetres? choose metres in the tracking software":
    "sind es Millimeter? In der Ortungssoftware Meter wählen",
  "its clock is {n} s ahead; times of arrival are taken instead":
    "seine Uhr geht {n} s vor; es gilt die Zeit der Ankunft",
  "its clock is {n} s behind; times of arrival are taken instead":
    "seine Uhr geht {n} s nach; es gilt die Zeit der Ankunft",
  "no MQTT broker answers at {name}; is it running (mosquitto), is mqtt.port right?":
    "kein MQTT-Broker antwortet unter {name}; läuft er (mosquitto), stimmt mqtt.port?",
  "no body is seen; is the tracking system live?": "kein Körper ist zu sehen; läuft die Ortung?",
  ["no drone answers at {name} within {n} s: is it switched on, and is your computer in the " +
    "drone's Wi-Fi?"]:
    "unter {name} antwortet nach {n} s keine Drohne: ist sie eingeschaltet und der Rechner " +
      "in ihrem WLAN?",
  "nobody answers at {name}; is it switched on, and in this network?":
    "niemand antwortet unter {name}; ist das Gerät an und in diesem Netz?",
  "nobody answers at {name}; is {what} running, and does it stream?":
    "niemand antwortet unter {name}; läuft {what}, und sendet es?",
  "nobody listens to it; is the perception process running?":
    "niemand hört darauf; läuft der Prozess „perception“?",
  "what is published there ({name}) is {found}; allowed: {words}":
    "was dort gesendet wird ({name}), ist {found}; erlaubt: {words}",
  "{n} nodes publish on {topic} ({names}): none is believed; give each scanner a topic of its own":
    "{n} Knoten senden auf {topic} ({names}): keinem wird geglaubt; jeder Scanner braucht ein " +
    "eigenes Topic",
  "not connected to {name} yet": "noch nicht mit {name} verbunden",
  "not heard yet; it sends its state at least every {k} s":
    "noch nicht gehört; sendet sonst mindestens alle {k} s",
  "offline: its last will says so; is it switched on and in reach of the network?":
    "abgemeldet; ist das Gerät an und in Reichweite des Netzes?",
  "poses are refused, {pose}: {ask}": "Posen werden abgelehnt, {pose}: {ask}",
  "sends more than {n} messages a second; the rest is dropped":
    "sendet mehr als {n} Nachrichten je Sekunde; der Rest fällt weg",
  "silent for {n} s; it sends its state at least every {k} s":
    "schweigt seit {n} s; sendet sonst mindestens alle {k} s",
  "speaks of more than {n} things": "meldet mehr als {n} Dinge",
  "the MQTT broker at {name} refuses us ({error})":
    "der MQTT-Broker unter {name} weist uns ab ({error})",
  "the MQTT broker at {name} refuses us; check mqtt.username and mqtt.password_file":
    "der MQTT-Broker unter {name} weist uns ab; mqtt.username und mqtt.password_file prüfen",
  "the connection to {name} was lost": "die Verbindung zu {name} ging verloren",
  "the driver's process does not answer (its log: driver.log)":
    "der Prozess des Treibers antwortet nicht (Protokoll: driver.log)",
  "the drone has not confirmed its limits yet":
    "die Drohne hat ihre Grenzwerte noch nicht bestätigt",
  "the drone is silent; is it switched on?": "die Drohne schweigt; ist sie eingeschaltet?",
  "the drone keeps {setting} = {kept} instead of {wanted}":
    "die Drohne behält {setting} = {kept} statt {wanted}",
  "the pilot is not heard": "der Autopilot schweigt",
  "the room's process does not answer (its log: room.log)":
    "der Prozess des Raums antwortet nicht (Protokoll: room.log)",
  "what answers at {name} does not speak {protocol} ({error})":
    "was unter {name} antwortet, spricht nicht {protocol} ({error})",
  "{name} sends more than {n} frames a second; the rest is dropped":
    "{name} sendet mehr als {n} Bilder je Sekunde; der Rest fällt weg",
  "{name} streams with y up; choose z up in the tracking software":
    "{name} sendet mit y nach oben; in der Ortungssoftware z nach oben wählen",
  "{name}: no depth images": "{name}: keine Tiefenbilder",
  "{name}: reading failed ({error})": "{name}: Lesen misslang ({error})",
  "'{title}' has the drone": "„{title}“ hat die Drohne",
  "'{title}' is not allowed to start from here": "„{title}“ darf von hier nicht beginnen",
  "'{title}' took the drone": "„{title}“ hat die Drohne übernommen",
  "Asked for by {who}": "Gewünscht von {who}",
  "Fly '{title}'? {why}.": "„{title}“ fliegen? {why}.",
  "Go on with '{title}'? {why}.": "„{title}“ fortsetzen? {why}.",
  "Start '{title}'? {why}.": "„{title}“ beginnen? {why}.",
  "It waited long": "Der Auftrag hat lange gewartet",
  "The program was started again": "Das Programm wurde neu gestartet",
  "a more urgent task took the drone": "eine dringendere Aufgabe hat die Drohne übernommen",
  "a person": "jemand",
  "a person flies the drone": "jemand steuert die Drohne",
  "a person ordered the drone before it began": "vor dem Beginn hat jemand der Drohne befohlen",
  "a step failed": "ein Schritt misslang",
  "a step failed inside ({error}); the log says why":
    "ein Schritt brach ab ({error}); das Protokoll sagt, warum",
  "also asked for by {who}": "auch von {who} gewünscht",
  "it could not be rehearsed ({why}), so it does not fly":
    "die Probe war nicht möglich ({why}), daher kein Flug",
  "it could not begin in time": "ein rechtzeitiger Beginn war nicht möglich",
  "it is next": "als Nächstes an der Reihe",
  "it is not known what to look at": "unbekannt, was anzusehen ist",
  "it is rehearsed": "wird geprobt",
  "it takes {time} and {p} % of the charge; {q} % are left above what the way home needs":
    "dauert {time} und braucht {p} % der Ladung; über den Heimweg hinaus sind {q} % übrig",
  "it was cancelled": "wurde abgebrochen",
  "it would land {d} m from the pad": "sie würde {d} m neben dem Landeplatz landen",
  "its deadline is over already": "die Frist ist schon vorbei",
  "nobody is seen": "niemand ist zu sehen",
  "nobody said yes in time": "niemand hat rechtzeitig Ja gesagt",
  "not done after {time}": "nach {time} nicht fertig",
  "not looked at yet": "noch nicht geprüft",
  "nothing flies": "nichts fliegt",
  "on the ground, ready": "am Boden, bereit",
  "other tasks run": "andere Aufgaben laufen",
  "the drone is not ready": "die Drohne ist nicht bereit",
  "the drone is {phase}, which this task did not order":
    "die Drohne tut, was diese Aufgabe nicht befahl: {phase}",
  "the drone would touch {thing}": "die Drohne würde {thing} berühren",
  "the motors are off: the drone fell or was cut":
    "die Motoren sind aus: die Drohne fiel oder wurde abgeschaltet",
  "the pilot does not answer": "der Autopilot antwortet nicht",
  "the pilot has not said yet whether it may take off":
    "der Autopilot hat den Start noch nicht freigegeben",
  "the program ended while it flew; nothing starts again without a fresh order":
    "das Programm endete im Flug; ohne neuen Befehl beginnt nichts wieder",
  "the program ended while it ran": "das Programm endete währenddessen",
  "the queue was full, it made way": "die Warteschlange war voll, anderes ging vor",
  "the queue was full, it made way for '{title}'":
    "die Warteschlange war voll, „{title}“ ging vor",
  "the tasks have just begun": "die Aufgaben haben eben begonnen",
  "{n} before it": "{n} davor",
  "{n} tasks of {who} wait already; answer or cancel one":
    "{n} Aufgaben von {who} warten schon; eine beantworten oder abbrechen",
  "{n} tasks wait already; cancel one or ask later":
    "{n} Aufgaben warten schon; eine abbrechen oder später fragen",
  "{what} took longer than {n} s": "{what} dauerte länger als {n} s",
  "{what}: {why}": "{what}: {why}",
  "{who} cancelled it": "{who} hat abgebrochen",
  "{who} continued it": "{who} hat fortgesetzt",
  "{who} paused it": "{who} hat unterbrochen",
  "{who} said no": "{who} hat Nein gesagt",
  "{who} said yes": "{who} hat Ja gesagt",
  "{who} took over: {what}": "{who} hat übernommen: {what}",
  "done": "erledigt",
  "the task took too long": "die Aufgabe dauerte zu lange",
  // what a Crazyflie complains of
  "it does not fly as it is told":
    "sie fliegt nicht, wie man ihr sagt",
  "it answers, but sends no reports":
    "sie antwortet, sendet aber keine Berichte",
  "the drone has locked itself: switch it off and on":
    "die Drohne hat sich gesperrt: aus- und einschalten",
  "the drone has crashed: look it over, then reset":
    "die Drohne ist abgestürzt: ansehen, dann zurücksetzen",
  "the drone believes to be {d} m from where tracking sees it: do poses reach it?":
    "die Drohne glaubt sich {d} m von dort, wo die Ortung sie sieht: Erreichen sie Posen?",
  "a deck on the drone reports a fault: switch it off and look at the deck":
    "ein Deck der Drohne meldet einen Fehler: ausschalten und das Deck ansehen",
  // what an ArduCopter or a PX4 is told to be set to, and refuses
  "its map has no origin yet: it must be told where it is, standing":
    "ihre Karte hat noch keinen Ursprung: Man muss ihr im Stehen sagen, wo sie ist",
  "set {setting} to {allowed} on the drone (it is {value}): {why}":
    "an der Drohne {setting} auf {allowed} setzen (jetzt {value}): {why}",
  "the drone does not tell its {setting} yet": "die Drohne meldet ihr {setting} noch nicht",
  "somebody else flies it, or it does by itself (mode {mode})":
    "jemand anders fliegt sie, oder sie sich selbst (Modus {mode})",
  "the drone will not {what}": "die Drohne weigert sich: {what}",
  "denied": "abgelehnt",
  "it flies on when the ground falls silent": "sie fliegt weiter, wenn der Boden schweigt",
  "it does not fly by the poses that we send": "sie fliegt nicht nach den Posen, die wir senden",
  // what cannot be looked at
  "there is no free way to where {name} can be seen from":
    "kein freier Weg führt dorthin, wo {name} zu sehen ist",
  "there is no place within {d} m of {name} where the drone may hover and tracking sees it":
    "im Umkreis von {d} m um {name} gibt es keinen Ort, wo die Drohne schweben darf und " +
      "die Ortung sie sieht",
  "{name} is nowhere in the picture: too near, too high or too low":
    "{name} ist nirgends im Bild: zu nah, zu hoch oder zu tief",
  "{name} cannot be seen from any place where the drone may hover: something stands in between":
    "{name} ist von keinem Ort zu sehen, wo die Drohne schweben darf: etwas steht dazwischen",
  "{who} is in the way": "{who} ist im Weg",
  "nobody knows where {name} is": "niemand weiß, wo {name} ist",
  // what happened lately, and rules
  "may have fallen": "ist vielleicht gestürzt",
  "up again": "wieder auf",
  "out of sight": "außer Sicht",
  "on": "an",
  "off": "aus",
  "open": "offen",
  "closed": "zu",
  "open for too long": "zu lange offen",
  "somebody is in it": "jemand liegt darin",
  "empty": "leer",
  "missing": "fehlt",
  "back": "wieder da",
  "somebody is there": "jemand ist da",
  "nobody is there": "niemand ist mehr da",
  "rang": "hat geklingelt",
  "saw motion": "Bewegung",
  "{first}, then {next}": "{first}, dann {next}",
  "{n} s in the air": "{n} s in der Luft",
  "with {who}": "bei {who}",
  "taken": "genommen",
  "put down": "abgelegt",
  "{what} ({who})": "{what} ({who})",
  "asked for by {who}": "erbeten von {who}",
  "Mode of the house": "Betriebsart des Hauses",
  "a picture was kept": "ein Bild wurde aufbewahrt",
  "When the bell rings": "Wenn es klingelt",
  "When somebody may have fallen": "Wenn jemand vielleicht gestürzt ist",
  "{when}, if {what}": "{when}, wenn {what}",
  "When the webhook {name} is called": "Wenn der Webhook {name} gerufen wird",
  "Every {n} min": "Alle {n} min",
  "Every day at {time}": "Jeden Tag um {time}",
  "On {days} at {time}": "{days} um {time}",
  "When {what}": "Wenn {what}",
  "this room has no place called {place}: make one in the room editor":
    "in diesem Raum heißt kein Ort {place}: im Raumeditor einen anlegen",
  // what is done to a simulated room
  "this room is simulated": "dieser Raum ist simuliert",
  "there is no drone called {name}": "keine Drohne heißt {name}",
  "somebody carries the drone to its pad": "jemand trägt die Drohne zu ihrem Landeplatz",
  "the drone has a full battery": "der Akku der Drohne ist voll",
  "somebody walks up to the drone, and leaves after {n} s":
    "jemand geht auf die Drohne zu und ist nach {n} s wieder weg",
  "{what}, for {n} s": "{what}, {n} s lang",
  "the faults that were made are over": "die ausgelösten Störungen sind zu Ende",
  "nobody takes hold of a drone whose propellers turn":
    "niemand fasst eine Drohne an, deren Propeller sich drehen",
  "nobody charges a drone whose propellers turn":
    "niemand lädt eine Drohne, deren Propeller sich drehen",
  "the simulated room does not answer": "der simulierte Raum antwortet nicht",
  "no tracking for 5 s, or for good": "keine Ortung, 5 s lang oder für immer",
  "the drone and another body are exchanged": "die Drohne und ein anderer Körper sind vertauscht",
  "frozen poses under fresh stamps": "stehende Posen mit frischen Zeiten",
  "tracking falls to 10 Hz": "die Ortung fällt auf 10 Hz",
  "tracking is late, with or without saying so":
    "die Ortung kommt zu spät, mit oder ohne es zu sagen",
  "the tracked place drifts, or steps once a second":
    "der geortete Ort wandert oder springt jede Sekunde",
  "30 % of the datagrams to and from the drone are lost":
    "30 % der Datagramme von und zur Drohne gehen verloren",
  "the link to the drone is lost for good": "die Verbindung zur Drohne ist weg",
  "the drone falls silent and still obeys": "die Drohne schweigt und gehorcht noch",
  "the pictures stop, are damaged or stand still":
    "die Bilder bleiben aus, sind beschädigt oder stehen",
  "the charge falls off a cliff": "die Ladung bricht ein",
  "a weak motor, a damaged propeller, a sagging battery":
    "schwacher Motor, beschädigter Propeller, schwacher Akku",
  "a motor stands still": "ein Motor steht",
  "held by something: tether, load, fan, wind": "festgehalten: Leine, Last, Ventilator, Wind",
  "a chair is put on the way": "ein Stuhl wird in den Weg gestellt",
  "somebody steps in front, walks up to it, or crosses":
    "jemand tritt davor, geht darauf zu oder kreuzt",
  "somebody or something is on the pad": "jemand oder etwas ist auf dem Landeplatz",
  "the drone's optical flow fails": "der optische Fluss der Drohne fällt aus",
  "the drone's sonar fails": "der Ultraschall der Drohne fällt aus",
  "the scanners fail": "die Scanner fallen aus",
};
