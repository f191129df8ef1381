"""It refuses a velocity and moves all the same."""

import honest


class Broken(honest.Program):
    def answer(self, request, **what):
        super().answer(request, **({"error": "the door is open"} if request.get("do") == "velocity" else what))


Broken().run()
