"""It moves on clear."""

import honest


class Broken(honest.Program):
    def on_clear(self, request):
        self.device.rates, self.expires_at = [0.01, 0.0, 0.0], float("inf")
        super().on_clear(request)


Broken().run()
