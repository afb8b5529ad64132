package org.starl.apps.intersection.robot;

import java.util.Locale;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.apps.Request;
import org.starl.apps.intersection.logic.FlowingCar;
import org.starl.apps.intersection.logic.IcpProgram;
import org.starl.apps.intersection.logic.IntersectionApp;
import org.starl.apps.intersection.logic.Trip;
import org.starl.id.Participants;

/** The programs that a car may run. Cars of different programs can meet at one intersection. */
public enum CarProgram implements CarMaker {
  /** {@link FlowingCar}, which keeps moving. */
  FLOW,
  /** {@link IntersectionApp}, after Figure 4. */
  PAPER,
  /** {@link IcpProgram}, after Figure 3, made of {@code IcpProgram.starl}. */
  PROGRAM;

  /** The choice of the parameter {@code car}. */
  public static CarProgram of(Request request) {
    return valueOf(request.choice(IntersectionFactory.CAR).toUpperCase(Locale.ROOT));
  }

  @Override
  public LogicThread of(GlobalVarHolder gvh, Trip trip, Participants acceptors) {
    return switch (this) {
      case FLOW -> new FlowingCar(gvh, IntersectionFactory.XID, trip, acceptors);
      case PAPER -> new IntersectionApp(gvh, IntersectionFactory.XID, trip, acceptors);
      case PROGRAM -> new IcpProgram(gvh, IntersectionFactory.XID, trip, acceptors);
    };
  }
}
