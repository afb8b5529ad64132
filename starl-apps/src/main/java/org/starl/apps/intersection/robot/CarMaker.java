package org.starl.apps.intersection.robot;

import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.apps.intersection.logic.Trip;
import org.starl.id.Participants;

/** Makes the program of a car. */
@FunctionalInterface
public interface CarMaker {

  /**
   * A car's program.
   *
   * @param acceptors of the registrations
   */
  LogicThread of(GlobalVarHolder gvh, Trip trip, Participants acceptors);
}
