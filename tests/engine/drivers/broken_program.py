"""A robot or a heater that breaks one rule of docs/program-driver.md, named by its first argument."""

import json
import os
import signal
import sys
import time

defect, role = sys.argv[1], sys.argv[2]
seq, at, rate, until, goal, heating, heat_until = 0, 0.0, 0.0, 0.0, None, False, 0.0
heard = last = time.monotonic()
clock_off = 0.0


def write(line):
    global seq
    seq += 1
    if defect == "seq" and seq == 9:
        seq = 19
    sys.stdout.write(json.dumps({**line, "seq": seq, "time": time.monotonic() + clock_off}) + "\n")
    sys.stdout.flush()


def advance():
    global at, last, heating, rate
    now = time.monotonic()
    end = until if defect == "dead-man" else min(until, heard + 1.0)
    if defect == "valid_for" and rate:
        end = heard + 1.0
    at += rate * max(0.0, min(now, end) - last)
    if now > end and defect != "always moving":
        rate = 0.0
    last = now
    heating = heating and now < (heat_until if defect == "dead-man" else min(heat_until, heard + 1.0))


def state():
    if role == "heater":
        return {"temperature": 300.0, "heating": heating}
    position = [1000.0 * at if defect == "millimetres" else -at if defect == "sign" else at]
    moving = defect == "always moving" or (rate != 0.0 and defect != "never moving")
    return {"position": position, "moving": moving, "sure": True, "alarm": ""}


def obey(what, request):
    global rate, until, heating, heat_until
    if what == "velocity":
        if len(request["rates"]) != 1:
            raise ValueError("one rate is wanted")
        rate, until = request["rates"][0], time.monotonic() + request["valid_for"]
    elif what == "stop" and defect != "stop":
        rate = 0.0
    elif what == "heat":
        if not isinstance(request["set_point"], float):
            raise ValueError("no set point")
        if request["set_point"] > 600.0 and defect != "max_temperature":
            raise ValueError("too hot")
        heating, heat_until = True, time.monotonic() + request["valid_for"]
    elif what == "off" and defect != "off":
        heating = False
    elif what not in ("stop", "off") and defect != "unknown request":
        raise ValueError("what is %s" % what)


if defect == "deaf to signals":
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
if defect == "exits":
    sys.exit("no such port: /dev/arm")
if defect == "babbles":
    while True:
        os.write(1, b"x" * 999 + b"\n")
if defect == "long line":
    os.write(1, b"x" * 100_000_000)
reads = 0
while True:
    text = sys.stdin.readline()
    if not text:
        break
    advance()
    heard = time.monotonic()
    try:
        request = json.loads(text)
        what, number = request["do"], request["id"]
    except (ValueError, KeyError, TypeError):
        if defect == "crashes":
            raise
        write({"id": None, "error": "not a request"})
        continue
    if what == "hello":
        if defect == "no hello":
            continue
        hello = {"protocol": 2 if defect == "protocol" else 1, "role": "thermometer" if defect == "role" else role,
                 "name": "Broken", "axes": ["x"], "moves": "velocity", "max_temperature": 600.0}
        write({"id": number, "hello": hello})
    elif what == "read":
        reads += 1
        if defect == "slow":
            time.sleep(0.7)
        if defect == "hangs" and reads == 5:
            time.sleep(1000)
        if defect == "clock" and reads == 5:
            clock_off = 100.0
        if defect == "prints" and reads == 5:
            print("position:", at)
        answer = state()
        if defect == "not finite" and reads == 5:
            answer["position"] = [float("nan")]
        write({"id": number + 1 if defect == "id" else number, "state": answer})
    else:
        try:
            obey(what, request)
            write({"id": number, "ok": True})
        except ValueError as error:
            write({"id": number, "error": str(error)})
if defect in ("end of input", "deaf to signals"):
    time.sleep(1000)
