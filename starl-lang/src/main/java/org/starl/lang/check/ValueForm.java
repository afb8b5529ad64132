package org.starl.lang.check;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.starl.lang.eval.Form;
import org.starl.lang.eval.Id;
import org.starl.lang.eval.Num;
import org.starl.lang.eval.Row;

/** Values, and the names of their groups, in a file: a byte for the kind, then what is in it. */
final class ValueForm {

  private static final int FALSE = 0;
  private static final int TRUE = 1;
  private static final int NUMBER = 2;
  private static final int ID = 3;
  private static final int SET = 4;
  private static final int NONE = 5;
  private static final int SOME = 6;
  private static final int FORM = 7;
  private static final int ROW = 8;
  private static final int TEXT = 9;

  private ValueForm() {}

  static void write(Object value, DataOutput out) throws IOException {
    switch (value) {
      case Boolean bool -> out.writeByte(bool ? TRUE : FALSE);
      case Num num -> {
        out.writeByte(NUMBER);
        out.writeLong(num.over());
        out.writeLong(num.under());
      }
      case Id id -> {
        out.writeByte(ID);
        out.writeInt(id.number());
      }
      case BigInteger set -> {
        out.writeByte(SET);
        byte[] bits = set.toByteArray();
        out.writeInt(bits.length);
        out.write(bits);
      }
      case Optional<?> option when option.isPresent() -> {
        out.writeByte(SOME);
        write(option.get(), out);
      }
      case Optional<?> none -> out.writeByte(NONE);
      case Form form -> {
        out.writeByte(FORM);
        out.writeInt(form.constructor());
        write(form.fields(), out);
      }
      case Row row -> {
        out.writeByte(ROW);
        out.writeInt(row.size());
        for (int i = 0; i < row.size(); i++) {
          write(row.get(i), out);
        }
      }
      case String text -> {
        out.writeByte(TEXT);
        out.writeUTF(text);
      }
      default -> throw new IllegalArgumentException("no value: " + value.getClass());
    }
  }

  static Object read(DataInput in) throws IOException {
    int kind = in.readByte();
    return switch (kind) {
      case FALSE -> false;
      case TRUE -> true;
      case NUMBER -> new Num(in.readLong(), in.readLong());
      case ID -> new Id(in.readInt());
      case SET -> {
        byte[] bits = new byte[in.readInt()];
        in.readFully(bits);
        yield new BigInteger(bits);
      }
      case NONE -> Optional.empty();
      case SOME -> Optional.of(read(in));
      case FORM -> new Form(in.readInt(), (Row) read(in));
      case ROW -> {
        List<Object> items = new ArrayList<>();
        for (int left = in.readInt(); left > 0; left--) {
          items.add(read(in));
        }
        yield Row.of(items);
      }
      case TEXT -> in.readUTF();
      default -> throw new IOException("no kind of value: " + kind);
    };
  }
}
