"""It moves on a velocity with too few rates."""

import honest


class Broken(honest.Program):
    def on_velocity(self, request):
        request["rates"] = (list(request.get("rates") or []) + [0.0] * 3)[:3]
        super().on_velocity(request)


Broken().run()
