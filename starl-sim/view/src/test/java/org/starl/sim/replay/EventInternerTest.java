package org.starl.sim.replay;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;

class EventInternerTest {

  private static final RobotId BOT0 = new RobotId("bot0");
  private static final RobotId BOT1 = new RobotId("bot1");
  private static final Instance TALK = Instance.of("talk", "1");

  private record Word(String text) {
    static final RecordShape<Word> SHAPE =
        Shapes.of(Word.class, Shapes.part("text", Shapes.TEXT, Word::text), Word::new);
  }

  private final EventInterner interner = new EventInterner();

  private Object sent(String text) {
    Sent sent = new Sent(0, BOT0, Sent.ALL, TALK, 1, 9, Word.SHAPE, new Word(text));
    return ((Sent) interner.intern(sent)).message();
  }

  private Object delivered(String text) {
    Delivered delivered = new Delivered(1, BOT1, BOT0, TALK, 1, Word.SHAPE, new Word(text));
    return ((Delivered) interner.intern(delivered)).message();
  }

  @Test
  void receiversShareTheSendersMessage() {
    Object first = sent("hello");
    long before = interner.bytes();
    assertThat(delivered("hello")).isSameAs(first);
    long ofShared = interner.bytes() - before;
    assertThat(delivered("other")).isEqualTo(new Word("other"));
    assertThat(interner.bytes() - before - ofShared).isGreaterThan(ofShared);
  }

  @Test
  void aLongMessageCountsMore() {
    sent("a");
    long ofShort = interner.bytes();
    sent("a".repeat(1000));
    assertThat(interner.bytes() - ofShort).isGreaterThan(1000);
  }

  @Test
  void manyDifferentValuesAreKeptUnchanged() {
    for (int i = 0; i < 100_000; i++) {
      assertThat(sent("word" + i)).isEqualTo(new Word("word" + i));
    }
  }
}
