// Press LIBRARY OBJECT AGAINST: a box led onto a plate through libthigma_c.so, by P/Invoke. As ../press.c.
using System;
using System.Globalization;
using System.Reflection;
using System.Runtime.InteropServices;

unsafe struct Handle {
  public uint StructSize, Buttons;
  public fixed double Pose[7];
}

unsafe struct Sample {
  public uint StructSize;
  public int Fault;
  public ulong Frame;
  public double Time;
  public fixed double HandlePose[7];
  public fixed double Pose[7];
  public fixed double ContactWrench[6];
  public fixed double Command[6];
  public double Penetration;
  public long Contacts;
}

struct Options {
  public uint StructSize;
  public int HasThreads;
  public IntPtr Device, Recording;
  public double Duration, Rate;
  public ulong Seed;
}

static unsafe class Door {
  const string Library = "thigma_c";
  [DllImport(Library)] public static extern IntPtr thigma_last_error();
  [DllImport(Library)]
  public static extern int thigma_scene_pair([MarshalAs(UnmanagedType.LPUTF8Str)] string held,
      [MarshalAs(UnmanagedType.LPUTF8Str)] string against, double scale, double* pose, out IntPtr scene);
  [DllImport(Library)] public static extern void thigma_scene_free(IntPtr scene);
  [DllImport(Library)] public static extern void thigma_session_options_init(ref Options options);
  [DllImport(Library)]
  public static extern int thigma_session_open(IntPtr scene, ref Options options, out IntPtr session);
  [DllImport(Library)]
  public static extern int thigma_session_step(IntPtr session, ulong frames, ref Handle handle, ref Sample sample);
  [DllImport(Library)] public static extern void thigma_session_free(IntPtr session);
}

static unsafe class Press {
  static void Check(int result) {
    if (result != 0) throw new InvalidOperationException(Marshal.PtrToStringUTF8(Door.thigma_last_error()));
  }

  static int Main(string[] arguments) {
    if (arguments.Length != 3) return 2;
    NativeLibrary.SetDllImportResolver(Assembly.GetExecutingAssembly(),
        (name, assembly, path) => name == "thigma_c" ? NativeLibrary.Load(arguments[0]) : IntPtr.Zero);
    double* above = stackalloc double[7] { 0, 0, 0.03, 0, 0, 0, 1 };
    Check(Door.thigma_scene_pair(arguments[1], arguments[2], 1.0, above, out IntPtr scene));
    var options = new Options();
    Door.thigma_session_options_init(ref options);
    options.Device = Marshal.StringToCoTaskMemUTF8("null:");
    Check(Door.thigma_session_open(scene, ref options, out IntPtr session));
    Marshal.FreeCoTaskMem(options.Device);
    var handle = new Handle { StructSize = (uint)sizeof(Handle), Buttons = 1 };
    handle.Pose[6] = 1;
    var sample = new Sample { StructSize = (uint)sizeof(Sample) };
    for (int i = 0; i < 1000; ++i) {
      handle.Pose[2] = -2e-5 * i;
      Check(Door.thigma_session_step(session, 1, ref handle, ref sample));
    }
    Door.thigma_session_free(session);
    Door.thigma_scene_free(scene);
    Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "pressed with {0:F2} N at {1:F2} mm",
        sample.Command[2], 1e3 * sample.Pose[2]));
    return 0;
  }
}
