package org.starl.workload;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.primitives.agreement.AgreementSettings;
import org.starl.primitives.agreement.AgreementSpec;
import org.starl.primitives.agreement.SetAgreement;
import org.starl.shape.Shapes;

/** In each round all robots propose a value of their own. */
final class AgreementClient extends Client {

  private static final long THINK_MS = 50;

  /** Two to four times the longest wait in 360 runs, with delays of 1 to 200 ms. */
  private static final long PROMPT_MS = 200;

  private static final int PROMPT_MESSAGES = 20;

  // Created at the start: each serves as an acceptor even before this robot proposes.
  private final List<SetAgreement<Integer>> agreements = new ArrayList<>();

  private AgreementClient(GlobalVarHolder gvh, Setup setup) {
    super(gvh, setup, THINK_MS);
    AgreementSettings settings = AgreementSettings.DEFAULT.withDeadlineMs(setup.drawnDeadlineMs());
    for (int i = 0; i < setup.course().allRounds(); i++) {
      agreements.add(
          new SetAgreement<>(gvh, "round" + i, Shapes.U16, gvh.id.participants(), settings));
    }
  }

  static void setUp(Setup setup) {
    setup.place(gvh -> new AgreementClient(gvh, setup));
    setup.simulation().monitor(() -> new AgreementSpec(setup.withinNs()));
    setup.promise(PROMPT_MS, PROMPT_MESSAGES, false);
  }

  @Override
  protected boolean obtain(int round) {
    SetAgreement<Integer> agreement = agreements.get(round);
    agreement.propose(rng.nextInt(256) << 8 | rng.nextInt(256));
    await(() -> agreement.decided().get().isDecided() || agreement.failed().get());
    return agreement.decided().get().isDecided();
  }
}
