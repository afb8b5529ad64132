package org.starl.primitives.geocast;

import org.starl.id.RobotId;

/** Receives delivered messages, each once, on the strand. */
@FunctionalInterface
public interface GeocastHandler<T> {
  void delivered(RobotId origin, T message);
}
