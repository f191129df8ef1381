"""It heats on after valid_for."""

import honest


class Broken(honest.Program):
    def on_expired(self):
        self.expires_at = float("inf")


Broken().run()
