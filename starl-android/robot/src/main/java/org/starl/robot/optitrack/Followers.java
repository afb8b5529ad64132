package org.starl.robot.optitrack;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.starl.platform.Positioning;
import org.starl.platform.Strand;

/** The robots and observers that a feed gives its bodies to. From any thread. */
final class Followers {

  private record Follower(Predicate<TrackedBody> body, StrandPositioning positioning) {}

  private final List<Follower> followers = new CopyOnWriteArrayList<>();
  private final List<Consumer<List<TrackedBody>>> watchers = new CopyOnWriteArrayList<>();

  /**
   * The fixes of one body, on {@code strand}.
   *
   * @param name of the body, for messages
   */
  Positioning follow(Strand strand, String name, Predicate<TrackedBody> body) {
    StrandPositioning positioning = new StrandPositioning(strand, name);
    followers.add(new Follower(body, positioning));
    return positioning;
  }

  void watch(Consumer<List<TrackedBody>> watcher) {
    watchers.add(watcher);
  }

  void publish(List<TrackedBody> bodies) {
    if (bodies.isEmpty()) {
      return;
    }
    for (Follower follower : followers) {
      for (TrackedBody tracked : bodies) {
        if (tracked.fix() != null && follower.body().test(tracked)) {
          follower.positioning().offer(tracked.fix());
        }
      }
    }
    watchers.forEach(watcher -> watcher.accept(bodies));
  }
}
