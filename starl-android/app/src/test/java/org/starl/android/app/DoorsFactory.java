package org.starl.android.app;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.apps.AppFactory;
import org.starl.apps.Request;
import org.starl.apps.RobotProgram;
import org.starl.geometry.ItemPosition;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/** An app that violates its own specification while its wheels turn. */
public final class DoorsFactory implements AppFactory {

  /** Fact: a robot enters. */
  private record Enter() {}

  private static final RecordShape<Enter> ENTER = Shapes.of(Enter.class, Enter::new).named("enter");

  @Override
  public String name() {
    return "doors";
  }

  @Override
  public RobotProgram program(Request request) {
    return RobotProgram.of(EntersTwice::new).withMonitor(Once::new);
  }

  /** No robot enters twice. */
  private static final class Once implements Monitor {
    private boolean isInside;

    @Override
    public List<String> lemmas() {
      return List.of("Once");
    }

    @Override
    public List<String> perRobotLemmas() {
      return lemmas();
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      if (event instanceof Action action && action.fact() instanceof Enter) {
        if (isInside) {
          report.violated("Once", action.timeNs(), List.of(action.robot()), "is inside already");
        }
        isInside = true;
      }
    }
  }

  private static final class EntersTwice extends LogicThread {

    EntersTwice(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      await(gvh.gps::hasFix);
      gvh.trace.action(ENTER, new Enter());
      gvh.plat.moat.doMove(new ItemPosition("far", gvh.gps.pose().xMm() + 9000, 0));
      sleep(1500);
      gvh.trace.action(ENTER, new Enter());
      gvh.plat.moat.doMove(new ItemPosition("back", gvh.gps.pose().xMm() - 9000, 0));
      sleep(3_600_000);
      return List.of();
    }
  }
}
