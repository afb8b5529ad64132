package org.starl.primitives.paths;

import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.StableStorage;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

/** The stable storage of one robot for one instance. */
final class TubeStore {

  private final StableStorage stable;
  private final String prefix;

  TubeStore(StableStorage stable, String source) {
    this.stable = stable;
    this.prefix = source + ".";
  }

  /** The held tubes and, before the first grant, the disc at the robot's place; null if none. */
  @Nullable Holding own() {
    TubeVoter.Note stored = read(prefix + "own");
    return stored == null ? null : stored.holding();
  }

  void putOwn(Holding holding, Runnable flushed) {
    put(prefix + "own", new TubeVoter.Note(holding, false), flushed);
  }

  TubeVoter.@Nullable Note note(RobotId about) {
    return read(key(about));
  }

  private TubeVoter.@Nullable Note read(String key) {
    byte[] stored = stable.get(key);
    return stored == null ? null : TubeVoter.Note.SHAPE.read(new WireReader(stored));
  }

  void putNote(RobotId about, TubeVoter.Note note, Runnable flushed) {
    put(key(about), note, flushed);
  }

  private void put(String key, TubeVoter.Note note, Runnable flushed) {
    stable.put(key, WireWriter.toBytes(out -> TubeVoter.Note.SHAPE.write(note, out)), flushed);
  }

  private String key(RobotId about) {
    return prefix + "note." + about;
  }
}
