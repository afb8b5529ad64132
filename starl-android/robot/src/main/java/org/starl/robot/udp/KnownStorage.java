package org.starl.robot.udp;

import java.util.ArrayDeque;
import java.util.Queue;
import org.jspecify.annotations.Nullable;
import org.starl.platform.StableStorage;
import org.starl.platform.Strand;

/**
 * A robot's stable storage, in which nothing counts as flushed until the other robots know this
 * storage. A robot that has lost its storage begins with a new one: its promises in the old one are
 * forgotten, so it must not promise anything in the new one before the others could say so.
 *
 * <p>Once known, it stays known: that is written into it, so a later start does not wait.
 */
final class KnownStorage implements StableStorage {

  private static final String KEY = "starl.known";

  private final StableStorage below;
  private final Strand strand;
  private final Queue<Runnable> held = new ArrayDeque<>();

  // Written on the strand only.
  private boolean hasBegun;
  private volatile boolean isKnown;

  /**
   * Nothing is held before {@link #begin}.
   *
   * @param isAlone whether there is no other robot
   */
  KnownStorage(StableStorage below, Strand strand, boolean isAlone) {
    this.below = below;
    this.strand = strand;
    isKnown = isAlone || below.get(KEY) != null;
  }

  /** From now on writes wait until the storage is known. Strand only. */
  void begin() {
    hasBegun = true;
  }

  /** From any thread. */
  boolean isKnown() {
    return isKnown;
  }

  /** The other robots know it. From any thread; repeated calls do nothing. */
  void becomeKnown() {
    if (!isKnown) {
      strand.post(this::release);
    }
  }

  @Override
  public byte @Nullable [] get(String key) {
    return below.get(key);
  }

  @Override
  public void put(String key, byte[] value, Runnable flushed) {
    below.put(key, value, () -> flushed(flushed));
  }

  @Override
  public void remove(String key) {
    below.remove(key);
  }

  private void flushed(Runnable flushed) {
    if (hasBegun && !isKnown) {
      held.add(flushed);
    } else {
      flushed.run();
    }
  }

  // In the order of the writes: those that were held come before later ones.
  private void release() {
    if (!isKnown) {
      isKnown = true;
      below.put(KEY, new byte[] {1}, () -> {});
      while (!held.isEmpty()) {
        held.remove().run();
      }
    }
  }
}
