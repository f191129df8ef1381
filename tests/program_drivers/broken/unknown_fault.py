"""It tells a fault that does not exist."""

import honest


class Broken(honest.Program):
    def state(self):
        return dict(super().state(), faults=["", "broken", ""])


Broken().run()
