#!/usr/bin/env python3
"""An independent Modbus RTU server for modbus_peers_test: pymodbus_server.py PORT, or --check.

Unit 1. Holding and input registers 0 to 99: register k holds 1000 + k (holding) and 2000 + k (input); 3 holds 32767.
"""

import sys

from pymodbus.datastore import ModbusSequentialDataBlock, ModbusServerContext
from pymodbus.server import StartSerialServer

try:  # pymodbus 3.8 and later
    from pymodbus.framer import FramerType

    FRAMER = FramerType.RTU
except ImportError:
    from pymodbus.transaction import ModbusRtuFramer as FRAMER
try:
    from pymodbus.datastore import ModbusSlaveContext as DeviceContext
except ImportError:  # named anew in 3.9
    from pymodbus.datastore import ModbusDeviceContext as DeviceContext

import serial  # noqa: F401  pymodbus needs it, and tells only when it opens the port

try:
    import serial_asyncio  # noqa: F401
except ImportError:
    import pymodbus.transport  # noqa: F401  later versions bring their own


def block(first):
    values = [first + k for k in range(100)]
    values[3] = 32767
    return ModbusSequentialDataBlock(1, values)  # a device's address 0 is the block's 1


def context():
    device = DeviceContext(hr=block(1000), ir=block(2000))
    for words in ({"slaves": device}, {"devices": device}):
        try:
            return ModbusServerContext(single=True, **words)
        except TypeError:
            continue
    raise RuntimeError("this pymodbus has another server context")


if __name__ == "__main__":
    data = context()
    if sys.argv[1] != "--check":
        StartSerialServer(context=data, framer=FRAMER, port=sys.argv[1], baudrate=19200, parity="N")
