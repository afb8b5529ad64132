package org.starl.robot.create;

import java.util.List;
import java.util.function.Consumer;
import org.starl.platform.Strand;

/** Tells a program what holds its wheels, at each change. */
public final class HoldNews {

  private final Strand strand;

  // One thread.
  private List<CreateHold> last = List.of();

  // Strand only.
  private List<CreateHold> told = List.of();
  private Consumer<List<CreateHold>> receiver = holds -> {};

  public HoldNews(Strand strand) {
    this.strand = strand;
  }

  /** What holds the wheels now, from one thread, again and again. */
  public void now(List<CreateHold> holds) {
    if (!holds.equals(last)) {
      last = holds;
      strand.post(() -> {
        told = holds;
        receiver.accept(holds);
      });
    }
  }

  /** Gives the latest holds to {@code newReceiver}, and each later change. Strand only. */
  public void onChange(Consumer<List<CreateHold>> newReceiver) {
    receiver = newReceiver;
    newReceiver.accept(told);
  }
}
