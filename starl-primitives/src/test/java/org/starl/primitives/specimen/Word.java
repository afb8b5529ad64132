package org.starl.primitives.specimen;

import java.util.ArrayList;
import java.util.List;
import org.starl.comms.Codec;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

/** What specimens say to each other: what it is, a number, and names. */
record Word(String kind, long number, List<String> names) {

  static final Codec<Word> CODEC =
      new Codec<>() {
        @Override
        public void write(Word word, WireWriter out) {
          out.string(word.kind);
          out.i64(word.number);
          out.u16(word.names.size());
          word.names.forEach(out::string);
        }

        @Override
        public Word read(WireReader in) {
          String kind = in.string();
          long number = in.i64();
          List<String> names = new ArrayList<>();
          for (int i = in.u16(); i > 0; i--) {
            names.add(in.string());
          }
          return new Word(kind, number, names);
        }
      };

  Word(String kind, long number, String... names) {
    this(kind, number, List.of(names));
  }
}
