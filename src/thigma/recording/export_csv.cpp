#include "thigma/core/file.h"
#include "thigma/recording/detail/json_text.h"
#include "thigma/recording/recording.h"

namespace thigma {
namespace {

constexpr const char* kCsvHeader =
    "frame,time [s],device x [m],device y [m],device z [m],device qx,device qy,device qz,device "
    "qw,buttons,"
    "body x [m],body y [m],body z [m],body qx,body qy,body qz,body qw,"
    "Px [kg m/s],Py [kg m/s],Pz [kg m/s],Lx [kg m^2/s],Ly [kg m^2/s],Lz [kg m^2/s],"
    "contact fx [N],contact fy [N],contact fz [N],contact tx [N m],contact ty [N m],contact tz [N "
    "m],"
    "command fx [N],command fy [N],command fz [N],command tx [N m],command ty [N m],command tz [N "
    "m],"
    "feedback fx [N],feedback fy [N],feedback fz [N],feedback tx [N m],feedback ty [N m],feedback "
    "tz [N m],"
    "penetration [m],stretch [m],model age [s],energy [J],touching,grasped,armed,fault,step cpu "
    "[s],wake late [s]\n";

void put(std::string& row, double value) {
  row += ',';
  if (value == value) detail::put_number(row, value);  // an unknown stays empty
}

template <class Vector>
void put_vector(std::string& row, const Vector& v) {
  for (int i = 0; i < static_cast<int>(v.size()); ++i) put(row, v[i]);
}

void put_row(std::string& row, const HapticSample& s) {
  row += std::to_string(s.frame);
  put(row, s.time);
  put_vector(row, s.device.motion.pose.position);
  put_vector(row, s.device.motion.pose.orientation.coeffs());
  row += ',' + std::to_string(s.device.buttons);
  put_vector(row, s.body.position);
  put_vector(row, s.body.orientation.coeffs());
  put_vector(row, s.body.linear_momentum);
  put_vector(row, s.body.angular_momentum);
  for (const Wrench* wrench : {&s.contact, &s.command, &s.feedback}) {
    put_vector(row, wrench->force);
    put_vector(row, wrench->torque);
  }
  put(row, s.penetration);
  put(row, s.stretch);
  put(row, s.model_age);
  put(row, s.energy);
  row += ',' + std::to_string(s.touching);
  row += s.is_grasped ? ",1" : ",0";
  row += s.is_armed ? ",1," : ",0,";
  row += fault_name(s.fault);
  put(row, static_cast<double>(s.step_cpu));
  put(row, static_cast<double>(s.wake_late));
  row += '\n';
}

}  // namespace

CsvExport::CsvExport(const std::string& path)
    : file_(std::make_unique<FileWriter>(path)), rows_(kCsvHeader) {}

CsvExport::~CsvExport() = default;

void CsvExport::add(const HapticSample& sample) {
  constexpr std::size_t kMost = 1 << 20;
  put_row(rows_, sample);
  if (rows_.size() < kMost) return;
  file_->append(rows_);
  rows_.clear();
}

void CsvExport::keep() {
  file_->append(rows_);
  rows_.clear();
  file_->keep();
}

void export_csv(const Recording& recording, const std::string& path) {
  CsvExport csv(path);
  for (const HapticSample& sample : recording.frames) csv.add(sample);
  csv.keep();
}

}  // namespace thigma
