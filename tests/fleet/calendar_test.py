"""Reads the calendar of `host_sim fleet` with python3-icalendar, and checks the rules of RFC 5545 that a
reader forgives.

    calendar_test.py HOST_SIM MODEL
"""
import datetime
import subprocess
import sys
import tempfile

try:
    import icalendar
except ImportError:
    print("python3-icalendar is not there")
    sys.exit(77)

# At B10 for a shape of 5.94, ten hours a day of 0.001: 10 % more after 84.7 hours.
NAME = "Übermäßig langer Name, mit Komma; Strichpunkt und \\ – " + "ä" * 60
# One octet more before each character: one of both would be divided.
SHIFTED = "x" + NAME
TABLE = (f'tendon,damage,damage_per_h,hours_per_day\n"{NAME}",0.68464,1e-3,10\n"{SHIFTED}",0.68464,1e-3,10\n'
         "new,0,1e-3,10\n")


def calendar_of(host_sim, model, today, table=TABLE):
    with tempfile.TemporaryDirectory() as folder:
        with open(f"{folder}/t.csv", "w", encoding="utf-8") as file:
            file.write(table)
        subprocess.run([host_sim, "fleet", f"{folder}/t.csv", "--model", model, "--today", today, "--horizon", "30d",
                        "--calendar", f"{folder}/c.ics"], check=True, capture_output=True)
        with open(f"{folder}/c.ics", "rb") as file:
            return file.read()


def check(holds, what):
    if not holds:
        sys.exit(f"not so: {what}")


def events_of(text):
    return {str(event["SUMMARY"]): event for event in icalendar.Calendar.from_ical(text).walk("VEVENT")}


def main():
    host_sim, model = sys.argv[1:]
    text = calendar_of(host_sim, model, "2026-03-02")
    check(text.endswith(b"END:VCALENDAR\r\n"), "the end")
    for line in text.split(b"\r\n"):
        check(b"\n" not in line and b"\r" not in line, f"CRLF: {line}")
        check(len(line) <= 75, f"at most 75 octets: {line}")
        line.decode("utf-8")  # no character is divided
    unfolded = text.replace(b"\r\n ", b"").decode("utf-8")
    check("mit Komma\\; Strichpunkt und \\\\ – ä" in unfolded, "semicolon and backslash are escaped")
    check("Name\\, mit" in unfolded, "a comma is escaped")
    events = events_of(text)
    check(set(events) == {"Replace tendon " + NAME, "Replace tendon " + SHIFTED, "Plan the fleet again"},
          f"events {set(events)}")
    event = events["Replace tendon " + NAME]
    check(event["DTSTART"].dt == datetime.date(2026, 3, 10), "84.7 hours are 8 whole days")
    check(event["DTEND"].dt == datetime.date(2026, 3, 11), "an event of one day")
    check(event["DTSTAMP"].dt == datetime.datetime(2026, 3, 2, tzinfo=datetime.timezone.utc), "DTSTAMP is today")
    check(events["Plan the fleet again"]["DTSTART"].dt == datetime.date(2026, 4, 1), "30 days later")
    later = events_of(calendar_of(host_sim, model, "2026-03-05"))["Replace tendon " + NAME]
    check(later["UID"] == event["UID"], "the same tendon, the same UID")
    check(later["DTSTART"].dt == datetime.date(2026, 3, 13), "which moves")
    check(len({str(each["UID"]) for each in events.values()}) == len(events), "one UID for each")
    alone = events_of(calendar_of(host_sim, model, "2026-03-02",
                                  "tendon,damage,damage_per_h,hours_per_day\nidle,0,0,0\n"))
    check(set(alone) == {"Plan the fleet again"}, "a calendar has a component at least")
    print("read")


if __name__ == "__main__":
    main()
