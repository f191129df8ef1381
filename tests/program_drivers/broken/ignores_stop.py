"""It says ok to stop and goes on moving."""

import honest


class Broken(honest.Program):
    moves = "steps"

    def on_stop(self, request):
        self.answer(request, ok=True)


Broken().run()
