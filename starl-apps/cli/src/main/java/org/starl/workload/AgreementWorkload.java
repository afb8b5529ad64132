package org.starl.workload;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.primitives.agreement.AgreementSpec;
import org.starl.primitives.agreement.SetAgreement;
import org.starl.primitives.agreement.SynodTiming;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** {@code starl campaign agreement}: in each round all robots propose a value of their own. */
final class AgreementWorkload extends PrimitiveDemo {

  private static final long THINK_MS = 50;

  AgreementWorkload() {
    super("agreement", "robots agree on one value after another, each proposing its own");
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(rounds(10), busy("20s"));
  }

  @Override
  void prepare(Simulation.Builder simulation, Request request, SimSettings settings) {
    Course course = course(request);
    long withinNs = Bounds.withinNs(settings);
    long deadlineMs = Bounds.deadlineMs(withinNs);
    place(
        simulation, settings, count(request, 1, 64), gvh -> new Proposer(gvh, course, deadlineMs));
    simulation.monitor(() -> new AgreementSpec(withinNs));
  }

  private static final class Proposer extends Client {
    // All from the start: each serves as an acceptor, whether this robot proposes already or not.
    private final List<SetAgreement> agreements = new ArrayList<>();

    Proposer(GlobalVarHolder gvh, Course course, long deadlineMs) {
      super(gvh, course, THINK_MS);
      for (int i = 0; i < course.rounds(); i++) {
        agreements.add(
            new SetAgreement(
                gvh, "round" + i, gvh.id.participants(), SynodTiming.DEFAULT, deadlineMs));
      }
    }

    @Override
    protected boolean obtain(int round) {
      SetAgreement agreement = agreements.get(round);
      agreement.propose(new byte[] {(byte) rng.nextInt(256), (byte) rng.nextInt(256)});
      await(() -> agreement.decided().get().isDecided() || agreement.failed().get());
      return agreement.decided().get().isDecided();
    }
  }
}
