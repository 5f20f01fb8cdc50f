"""A Gymnasium environment of one scene: press a ball on a ring with a force that is asked for."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
import numpy.typing as npt
from gymnasium import spaces

import thigma

Numbers = npt.NDArray[np.float32]


class PressEnv(gymnasium.Env[Numbers, Numbers]):
    """A hand over a ring holds a ball and moves up and down.

    action       speed of the hand along z (1,), -1 to 1 times 0.1 m/s
    observation  height of the hand [10 mm] and of the ball over it [mm], force on the hand along z
                 [N], and the force that is wanted (4,)
    reward       - |force - wanted| [N], a frame of 10 ms
    """

    frames = 10  # haptic frames a step

    def __init__(self, seconds: float = 1.0) -> None:
        self.action_space = spaces.Box(-1.0, 1.0, (1,), np.float32)
        self.observation_space = spaces.Box(-np.inf, np.inf, (4,), np.float32)
        self._scene = thigma.scene_from_pair(
            thigma.Mesh.from_file("procedural:ball?triangles=320"),
            thigma.Mesh.from_file("procedural:torus?triangles=500"),
            pose=(0.0, 0.0, 0.055, 0.0, 0.0, 0.0, 1.0),
        )
        self._steps = round(1000 * seconds / self.frames)
        self._session: thigma.Session | None = None

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Numbers, dict[str, Any]]:
        super().reset(seed=seed)
        self.close()
        self._session = thigma.Session(self._scene, device="null:")
        self._wanted = float(self.np_random.uniform(0.5, 2.0))
        self._height, self._done = 0.0, 0
        self._session.step(self._pose())
        return self._observed()

    def step(self, action: Numbers) -> tuple[Numbers, float, bool, bool, dict[str, Any]]:
        assert self._session is not None, "reset comes first"
        speed = 0.1 * float(np.clip(action[0], -1.0, 1.0))
        for _ in range(self.frames):
            self._height = float(np.clip(self._height + 0.001 * speed, -0.03, 0.01))
            self._session.step(self._pose())
        self._done += 1
        observed, info = self._observed()
        reward = -abs(info["force"] - self._wanted)
        return observed, reward, False, self._done >= self._steps, info

    def close(self) -> None:
        if self._session is not None:
            self._session.close()
            self._session = None

    def _pose(self) -> tuple[float, ...]:
        return (0.0, 0.0, self._height, 0.0, 0.0, 0.0, 1.0)

    def _observed(self) -> tuple[Numbers, dict[str, Any]]:
        assert self._session is not None
        last = self._session.last
        assert last is not None
        force = float(last.command[2])
        above = float(last.pose[2] - last.handle[2])
        row = (100.0 * self._height, 1000.0 * above, force, self._wanted)
        return np.array(row, np.float32), {"force": force, "fault": last.fault}


if __name__ == "__main__":
    env = PressEnv()
    observation = env.reset(seed=1)[0]
    total, ended = 0.0, False
    while not ended:
        force, wanted = observation[2], observation[3]
        push = np.array([np.clip(force - wanted, -1.0, 1.0)], np.float32)  # down while it is too weak
        observation, reward, _terminated, ended, _info = env.step(push)
        total += reward
    env.close()
    print(f"wanted {observation[3]:.2f} N, has {observation[2]:.2f} N, reward {total:.1f}")
