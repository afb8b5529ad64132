package org.starl.workload;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.apps.Parameter;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.primitives.registration.Registration;
import org.starl.primitives.registration.RegistrationSettings;

/** Robots register, stay a while, and unregister. */
final class RegistrationClient extends Client {

  private static final long THINK_MS = 500;

  /** Two to four times the longest wait in 360 runs, with delays of 1 to 200 ms. */
  private static final long PROMPT_MS = 200;

  private static final int PROMPT_MESSAGES = 50;

  /** A robot stays for at most a twentieth of the busy time, so that some views live long. */
  private static final int STAYS = 20;

  /** Part of the stays that last up to {@link #LONG_MS}: so long that a robot must ask for newer views. */
  private static final double LONG = 0.1;

  private static final long LONG_MS = 3 * RegistrationSettings.DEFAULT.queryMs();

  private final Registration reg;
  private final long stayMs;

  static final String MOST = "most";

  static final Parameter VOTERS =
      Parameter.choice(
          "voters", "whether all robots vote (all), or more than half of them (most)", "all", MOST);

  private RegistrationClient(GlobalVarHolder gvh, Setup setup) {
    super(gvh, setup, THINK_MS);
    reg = registration("town", voters(setup), settings(setup));
    stayMs = Math.max(1, setup.course().busyMs() / STAYS);
  }

  private static RegistrationSettings settings(Setup setup) {
    return RegistrationSettings.DEFAULT.withDeadlineMs(setup.drawnDeadlineMs());
  }

  static void setUp(Setup setup) {
    setup.place(gvh -> new RegistrationClient(gvh, setup));
    setup.simulation().monitor(() -> setup.registered(settings(setup)));
    if (!isByMost(setup)) {
      setup.promise(PROMPT_MS, PROMPT_MESSAGES, false);
    }
  }

  private static boolean isByMost(Setup setup) {
    return setup.request().choice(VOTERS).equals(MOST);
  }

  /**
   * Those who do not vote hear of views only if they are told, or as an answer, and wait longer while
   * many compete.
   */
  private Participants voters(Setup setup) {
    List<RobotId> all = gvh.id.participants().asList();
    return Participants.of(isByMost(setup) ? all.subList(0, all.size() / 2 + 1) : all);
  }

  @Override
  protected boolean obtain(int round) {
    reg.do_register();
    await(() -> reg.mayRequest() || reg.failed().get());
    return reg.mayRequest();
  }

  @Override
  protected void use() {
    pause(rng.nextLong(0, rng.nextBoolean(LONG) ? LONG_MS : stayMs));
    while (!reg.isUnregistered()) {
      reg.unregister();
      await(() -> reg.isUnregistered() || reg.failed().get());
      if (reg.failed().get()) {
        pause(rng.nextLong(0, stayMs)); // it is still listed
        if (rng.nextBoolean(0.5)) {
          return; // and registers under another id
        }
      }
    }
  }
}
