package org.starl.workload;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.primitives.agreement.AgreementSpec;
import org.starl.primitives.agreement.SetAgreement;
import org.starl.primitives.agreement.SynodTiming;

/** In each round all robots propose a value of their own. */
final class AgreementClient extends Client {

  private static final long THINK_MS = 50;

  // Created at the start: each serves as an acceptor even before this robot proposes.
  private final List<SetAgreement> agreements = new ArrayList<>();

  private AgreementClient(GlobalVarHolder gvh, Setup setup) {
    super(gvh, setup, THINK_MS);
    for (int i = 0; i < setup.course().rounds(); i++) {
      agreements.add(
          new SetAgreement(
              gvh, "round" + i, gvh.id.participants(), SynodTiming.DEFAULT, setup.deadlineMs()));
    }
  }

  static void setUp(Setup setup) {
    setup.place(gvh -> new AgreementClient(gvh, setup));
    setup.simulation().monitor(() -> new AgreementSpec(setup.withinNs()));
  }

  @Override
  protected boolean obtain(int round) {
    SetAgreement agreement = agreements.get(round);
    agreement.propose(new byte[] {(byte) rng.nextInt(256), (byte) rng.nextInt(256)});
    await(() -> agreement.decided().get().isDecided() || agreement.failed().get());
    return agreement.decided().get().isDecided();
  }
}
