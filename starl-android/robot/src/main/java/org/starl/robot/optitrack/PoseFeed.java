package org.starl.robot.optitrack;

import java.util.List;
import java.util.SortedMap;
import java.util.function.Consumer;
import org.starl.geometry.Fix;
import org.starl.platform.Positioning;
import org.starl.platform.Strand;

/** The robots' positions from one measuring system. From any thread. */
public interface PoseFeed extends AutoCloseable {

  /** The fixes of the body {@code name}, on {@code strand}; only the newest if the strand is late. */
  Positioning positioning(Strand strand, String name);

  /**
   * Passes all bodies of each message to {@code watcher} from now on, on the feed's own thread; the
   * watcher must not block.
   */
  void onBodies(Consumer<List<TrackedBody>> watcher);

  /**
   * Judges the fixes of the body {@code name}, a robot, by its wheels, too.
   *
   * @param onDoubt called on the feed's own thread as soon as two streams of its poses contradict each
   *     other, or its wheels: it must stop until its next fix, and the call must not block
   */
  void own(String name, WheelPath path, Runnable onDoubt);

  /** The newest fix of each body, by its name; a copy. */
  SortedMap<String, Fix> newest();

  FeedStatistics statistics();

  /** If a body has no fix: what comes instead, and what to look at, for people. */
  String silence();

  /** Receives nothing more. */
  @Override
  void close();
}
