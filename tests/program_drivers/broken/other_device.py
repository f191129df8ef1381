"""After a restart it is another device: its serial number changes."""

import os

import honest


class Broken(honest.Program):
    def hello(self):
        return dict(super().hello(), serial=str(os.getpid()))


Broken().run()
