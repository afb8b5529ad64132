package org.starl.primitives.ledger;

import static org.starl.shape.Shapes.part;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.primitives.agreement.Value;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * A task that is not finished.
 *
 * @param what is to be done
 * @param claim the number of its latest claim, from 1; 0 before the first
 * @param holder the process that has claimed it; null while it is open
 * @param isBegun whether the holder is past the point of no return; then no lease ends the claim
 */
public record LedgerTask<T>(
    TaskId id, T what, long claim, @Nullable ProcessId holder, boolean isBegun) {

  /** With what is to be done in bytes. */
  static final Shape<LedgerTask<Value>> SHAPE =
      Shapes.of(
          type(),
          part("id", TaskId.SHAPE, LedgerTask::id),
          part("what", Value.SHAPE, LedgerTask::what),
          part("claim", Shapes.LONG, LedgerTask::claim),
          part(
              "holder",
              Shapes.optional(Shapes.PROCESS),
              task -> Optional.ofNullable(task.holder())),
          part("isBegun", Shapes.BOOL, LedgerTask::isBegun),
          (id, what, claim, holder, isBegun) ->
              new LedgerTask<>(id, what, claim, holder.orElse(null), isBegun));

  @SuppressWarnings("unchecked") // a class object has no type arguments
  private static Class<LedgerTask<Value>> type() {
    return (Class<LedgerTask<Value>>) (Class<?>) LedgerTask.class;
  }

  /** Whether any robot may claim it. */
  public boolean isOpen() {
    return holder == null;
  }

  boolean isHeldBy(ProcessId process, long ofClaim) {
    return process.equals(holder) && claim == ofClaim;
  }

  /** Whether a program of this robot, also an earlier one, has begun it. */
  boolean isBegunBy(ProcessId process, long ofClaim) {
    return isBegun && holder != null && holder.robot().equals(process.robot()) && claim == ofClaim;
  }

  LedgerTask<T> claimedBy(ProcessId who) {
    return new LedgerTask<>(id, what, claim + 1, who, false);
  }

  LedgerTask<T> begun() {
    return new LedgerTask<>(id, what, claim, holder, true);
  }

  LedgerTask<T> open() {
    return new LedgerTask<>(id, what, claim, null, false);
  }
}
