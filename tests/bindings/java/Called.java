// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs a program under the debugger's interface and writes which public members of org.jalon returned to their caller: those
// that threw are not among them.
//   java Called.java FOLDER_OF_CLASSES CLASS_PATH OUT_FOLDER "MAIN ARGUMENT ..." [OPTION ...]
// OUT_FOLDER/public.txt: what there is; OUT_FOLDER/called.txt: what returned.
import com.sun.jdi.Bootstrap;
import com.sun.jdi.Method;
import com.sun.jdi.ReferenceType;
import com.sun.jdi.VMDisconnectedException;
import com.sun.jdi.VirtualMachine;
import com.sun.jdi.connect.Connector;
import com.sun.jdi.connect.LaunchingConnector;
import com.sun.jdi.event.BreakpointEvent;
import com.sun.jdi.event.ClassPrepareEvent;
import com.sun.jdi.event.Event;
import com.sun.jdi.event.EventSet;
import com.sun.jdi.event.VMDisconnectEvent;
import com.sun.jdi.request.BreakpointRequest;
import com.sun.jdi.request.ClassPrepareRequest;
import com.sun.jdi.request.EventRequest;
import java.io.InputStream;
import java.lang.reflect.Executable;
import java.lang.reflect.Modifier;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

class Called {
  private static String plain(String type) {
    return type.replaceAll("[\\w.]*[.$](\\w+)", "$1");
  }

  /** "Cloud.select(boolean[], Task)"; a constructor has the name of its class twice. */
  private static String text(String type, String name, Stream<String> arguments) {
    return plain(type) + "." + (name.equals("<init>") ? plain(type) : plain(name)) + "("
        + arguments.map(Called::plain).collect(Collectors.joining(", ")) + ")";
  }

  /** The public members of the public classes of the folder, as text; classes gets the names of those classes. */
  private static Set<String> members(Path folder, Set<String> classes) throws Exception {
    final Set<String> members = new TreeSet<>();
    try (URLClassLoader loader = new URLClassLoader(new URL[] {folder.toUri().toURL()}); Stream<Path> files = Files.list(
        folder.resolve("org/jalon"))) {
      for (Path file : (Iterable<Path>) files.sorted()::iterator) {
        final String name = "org.jalon." + file.getFileName().toString().replace(".class", "");
        final Class<?> type = Class.forName(name, false, loader);
        if (!Modifier.isPublic(type.getModifiers()) || type.isInterface()) {
          continue;
        }
        classes.add(name);
        final Stream<Executable> all = Stream.concat(Stream.of(type.getDeclaredMethods()), Stream.of(type.getDeclaredConstructors()));
        all.filter(member -> Modifier.isPublic(member.getModifiers()) && !Modifier.isAbstract(member.getModifiers())
            && !member.isSynthetic()).forEach(member -> members.add(text(name, member.getName(),
                Stream.of(member.getParameterTypes()).map(Class::getTypeName))));
      }
    }
    return members;
  }

  private static VirtualMachine launch(String classPath, String main, List<String> options) throws Exception {
    final LaunchingConnector connector = Bootstrap.virtualMachineManager().defaultConnector();
    final Map<String, Connector.Argument> arguments = connector.defaultArguments();
    arguments.get("main").setValue(main);
    arguments.get("options").setValue("-cp " + classPath + " " + String.join(" ", options));
    return connector.launch(arguments);
  }

  private static void drain(InputStream from) {
    final Thread thread = new Thread(() -> {
      try {
        from.transferTo(System.out);
      } catch (java.io.IOException end) {
        System.out.flush();
      }
    });
    thread.start();
  }

  /** Asks for a stop at each return of the class's public members; two of them in one class make one list. */
  private static void watch(ReferenceType type, Map<Method, List<BreakpointRequest>> watched) {
    for (Method method : type.methods()) {
      if (!method.isPublic() || method.isAbstract() || method.isNative()) {
        continue;
      }
      final List<BreakpointRequest> requests = new ArrayList<>();
      for (int at : Returns.of(method.bytecodes())) {
        final BreakpointRequest request = type.virtualMachine().eventRequestManager()
            .createBreakpointRequest(method.locationOfCodeIndex(at));
        request.setSuspendPolicy(EventRequest.SUSPEND_EVENT_THREAD); // else the machine may end before it is asked
        request.enable();
        requests.add(request);
      }
      watched.put(method, requests);
    }
  }

  /** Stops that are taken away when they were met: events of all methods that return would have the machine interpret everything. */
  private static Set<String> called(VirtualMachine machine, Set<String> classes) throws InterruptedException {
    final ClassPrepareRequest loaded = machine.eventRequestManager().createClassPrepareRequest();
    loaded.addClassFilter("org.jalon.*");
    loaded.enable();
    final Map<Method, List<BreakpointRequest>> watched = new HashMap<>();
    final Set<String> called = new TreeSet<>();
    machine.resume();
    try {
      while (true) {
        final EventSet events = machine.eventQueue().remove();
        for (Event event : events) {
          if (event instanceof VMDisconnectEvent) {
            return called;
          } else if (event instanceof ClassPrepareEvent) {
            final ReferenceType type = ((ClassPrepareEvent) event).referenceType();
            if (classes.contains(type.name())) {
              watch(type, watched);
            }
          } else if (event instanceof BreakpointEvent) {
            final Method method = ((BreakpointEvent) event).location().method();
            final List<BreakpointRequest> requests = watched.remove(method);
            if (requests != null) {
              called.add(text(method.declaringType().name(), method.name(), method.argumentTypeNames().stream()));
              machine.eventRequestManager().deleteEventRequests(requests);
            }
          }
        }
        events.resume();
      }
    } catch (VMDisconnectedException end) {
      return called;
    }
  }

  public static void main(String[] given) throws Exception {
    final Path out = Files.createDirectories(Path.of(given[2]));
    final Set<String> classes = new TreeSet<>();
    Files.write(out.resolve("public.txt"), members(Path.of(given[0]), classes));
    final VirtualMachine machine = launch(given[1], given[3], List.of(given).subList(4, given.length));
    drain(machine.process().getInputStream());
    drain(machine.process().getErrorStream());
    Files.write(out.resolve("called.txt"), called(machine, classes));
    System.exit(machine.process().waitFor());
  }
}

/** Where a method's code gives back: JVM specification, chapter 6. */
class Returns {
  private static final int TABLESWITCH = 170, LOOKUPSWITCH = 171, FIRST_RETURN = 172, LAST_RETURN = 177, WIDE = 196, IINC = 132;
  /** Bytes of each instruction, 0 to 201, in runs "count x length". */
  private static final int[][] LENGTHS = {{16, 1}, {1, 2}, {1, 3}, {1, 2}, {2, 3}, {5, 2}, {28, 1}, {5, 2}, {73, 1}, {1, 3}, {20, 1},
      {16, 3}, {1, 2}, {2, 0}, {6, 1}, {7, 3}, {2, 5}, {1, 3}, {1, 2}, {1, 3}, {2, 1}, {2, 3}, {2, 1}, {1, 0}, {1, 4}, {2, 3}, {2, 5}};

  private static int[] lengths() {
    return Stream.of(LENGTHS).flatMapToInt(run -> IntStream.generate(() -> run[1]).limit(run[0])).toArray();
  }

  static List<Integer> of(byte[] code) {
    final int[] lengths = lengths();
    final ByteBuffer words = ByteBuffer.wrap(code);
    final List<Integer> found = new ArrayList<>();
    for (int at = 0; at < code.length;) {
      final int instruction = code[at] & 0xff;
      final int operands = (at + 4) & ~3; // of the two switches: on a boundary of four bytes
      if (instruction >= FIRST_RETURN && instruction <= LAST_RETURN) {
        found.add(at);
      }
      if (instruction == TABLESWITCH) {
        at = operands + 12 + 4 * (words.getInt(operands + 8) - words.getInt(operands + 4) + 1);
      } else if (instruction == LOOKUPSWITCH) {
        at = operands + 8 + 8 * words.getInt(operands + 4);
      } else if (instruction == WIDE) {
        at += (code[at + 1] & 0xff) == IINC ? 6 : 4;
      } else {
        at += lengths[instruction];
      }
    }
    return found;
  }
}
