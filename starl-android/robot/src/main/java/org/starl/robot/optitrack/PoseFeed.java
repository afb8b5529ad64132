package org.starl.robot.optitrack;

import java.util.List;
import java.util.function.Consumer;
import org.starl.platform.Positioning;
import org.starl.platform.Strand;

/** Where robots are, as one measuring system tells it. From any thread. */
public interface PoseFeed extends AutoCloseable {

  /** The fixes of the body {@code name}, on {@code strand}; where that is behind, the newest. */
  Positioning positioning(Strand strand, String name);

  /**
   * Tells all bodies of each message from now on, on the feed's own thread, which must not be held
   * up: to who merges, or looks on.
   */
  void onBodies(Consumer<List<TrackedBody>> watcher);

  FeedStatistics statistics();

  /** Hears nothing more. */
  @Override
  void close();
}
