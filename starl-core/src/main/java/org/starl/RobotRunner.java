package org.starl;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Platform;

/**
 * Starts one robot on a platform, simulated or real: counts the start in stable storage, builds the
 * gvh, creates the app and runs it.
 *
 * <p>An exception in the app or a handler is a bug: it propagates through the strand, whose owner
 * ends the run.
 */
public final class RobotRunner {

  private static final String BOOT_KEY = "starl.boot";

  private final Platform platform;
  private final Function<GlobalVarHolder, ? extends RobotApp> appFactory;
  private final Runnable whenFinished;
  private @Nullable GlobalVarHolder gvh;
  private @Nullable RobotApp app;
  private @Nullable List<Object> results;

  /**
   * @param whenFinished called on the strand when the app has finished
   */
  public RobotRunner(
      Platform platform,
      Function<GlobalVarHolder, ? extends RobotApp> appFactory,
      Runnable whenFinished) {
    this.platform = platform;
    this.appFactory = appFactory;
    this.whenFinished = whenFinished;
  }

  /** Starts the robot. Call it once, from any thread. */
  public void start() {
    platform.strand().post(this::boot);
  }

  /** Whether the app has finished. Strand only, as is everything below. */
  public boolean isFinished() {
    return results != null;
  }

  /** The app's results, or null before it has finished. */
  public @Nullable List<Object> results() {
    return results;
  }

  /** The app, or null before the robot has started. */
  public @Nullable RobotApp app() {
    return app;
  }

  /** The robot's gvh, or null before the robot has started. */
  public @Nullable GlobalVarHolder gvh() {
    return gvh;
  }

  // The boot number must be in stable storage before the first message carries it: otherwise a
  // crash in between would let the next start use the same number for another incarnation.
  private void boot() {
    byte[] stored = platform.stable().get(BOOT_KEY);
    int boot = (stored == null ? 0 : ByteBuffer.wrap(stored).getInt()) + 1;
    byte[] next = ByteBuffer.allocate(Integer.BYTES).putInt(boot).array();
    platform.stable().put(BOOT_KEY, next, () -> run(boot));
  }

  private void run(int boot) {
    GlobalVarHolder holder = new GlobalVarHolder(platform, boot);
    RobotApp logic = appFactory.apply(holder);
    gvh = holder;
    app = logic;
    logic.launch(this::finish);
  }

  private void finish(List<Object> appResults) {
    results = appResults;
    whenFinished.run();
  }
}
