package org.starl.primitives.paths;

import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.StableStorage;

/** What one robot must remember of an instance over a restart, in stable storage. */
final class TubeStore {

  private final StableStorage stable;
  private final String prefix;

  TubeStore(StableStorage stable, String source) {
    this.stable = stable;
    this.prefix = source + ".";
  }

  /** What this robot holds and, before its first grant, where it asked to stand; null if nothing. */
  @Nullable Holding own() {
    byte[] stored = stable.get(prefix + "own");
    return stored == null ? null : TubeCodec.holding(stored);
  }

  void putOwn(Holding holding, Runnable flushed) {
    stable.put(prefix + "own", TubeCodec.toBytes(holding, false), flushed);
  }

  TubeVoter.@Nullable Note note(RobotId about) {
    byte[] stored = stable.get(key(about));
    return stored == null
        ? null
        : new TubeVoter.Note(TubeCodec.holding(stored), TubeCodec.flag(stored));
  }

  void putNote(RobotId about, TubeVoter.Note note, Runnable flushed) {
    stable.put(key(about), TubeCodec.toBytes(note.holding(), note.voted()), flushed);
  }

  private String key(RobotId about) {
    return prefix + "note." + about;
  }
}
