(()=>{var bp=0,bh=1,wp=2;var cr=1,Tp=2,mo=3,Xs=0,Zn=1,Ki=2,ur=0,go=1,wh=2,Th=3,Ah=4,Ap=5;var hr=100,Ep=101,Cp=102,Rp=103,Pp=104,Ip=200,Lp=201,Np=202,Dp=203,Eh=204,Ch=205,Up=206,Fp=207,Op=208,Bp=209,kp=210,zp=211,Vp=212,Gp=213,Hp=214,Ll=0,Nl=1,Dl=2,no=3,Ul=4,Fl=5,Ol=6,Bl=7,Rh=0,Wp=1,Xp=2,ji=0,Ph=1,Ih=2,Lh=3,Nh=4,Dh=5,Uh=6,Sa=7;var Fh=300,fr=301,_o=302,hc=303,fc=304,kl=1e3,$i=1001,zl=1002,Pn=1003,qp=1004;var Ma=1005;var Yn=1006,dc=1007;var vs=1008;var kn=1009,Oh=1010,Bh=1011,xo=1012,pc=1013,Ni=1014,yi=1015,Di=1016,mc=1017,gc=1018,dr=1020,kh=35902,zh=35899,Vh=1021,Gh=1022,ei=1023,ps=1026,ys=1027,vo=1028,_c=1029,qs=1030,xc=1031;var vc=1033,ba=33776,wa=33777,Ta=33778,Aa=33779,yc=35840,Sc=35841,Mc=35842,bc=35843,wc=36196,Tc=37492,Ac=37496,Ec=37488,Cc=37489,Ea=37490,Rc=37491,Pc=37808,Ic=37809,Lc=37810,Nc=37811,Dc=37812,Uc=37813,Fc=37814,Oc=37815,Bc=37816,kc=37817,zc=37818,Vc=37819,Gc=37820,Hc=37821,Wc=36492,Xc=36494,qc=36495,$c=36283,Yc=36284,Ca=36285,Zc=36286;var Qo=2300,Vl=2301,Pl=2302,mh=2303,gh=2400,_h=2401,xh=2402;var $p=3200;var Jc=0,Yp=1,Ss="",qn="srgb",ea="srgb-linear",ta="linear",wt="srgb";var Il=7680;var Zp=519,Jp=512,Kp=513,jp=514,Hh=515,Qp=516,em=517,Wh=518,Xh=519,tm=35044;var qh="300 es",xi=2e3,io=2001;function sv(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function rv(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function na(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function nm(){let n=na("canvas");return n.style.display="block",n}var qd={},so=null;function $h(...n){let e="THREE."+n.shift();so?so("log",e,...n):console.log(e,...n)}function im(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function $e(...n){n=im(n);let e="THREE."+n.shift();if(so)so("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function Ke(...n){n=im(n);let e="THREE."+n.shift();if(so)so("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function jo(...n){let e=n.join(" ");e in qd||(qd[e]=!0,$e(...n))}function sm(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var rm={[Ll]:Ll,[Dl]:Ol,[Ul]:Ul,[no]:Fl,[Nl]:Nl,[Ol]:Dl,[Bl]:Bl,[Fl]:no},Yi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},On=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var qu=Math.PI/180,Gl=180/Math.PI;function Ra(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(On[n&255]+On[n>>8&255]+On[n>>16&255]+On[n>>24&255]+"-"+On[e&255]+On[e>>8&255]+"-"+On[e>>16&15|64]+On[e>>24&255]+"-"+On[t&63|128]+On[t>>8&255]+"-"+On[t>>16&255]+On[t>>24&255]+On[i&255]+On[i>>8&255]+On[i>>16&255]+On[i>>24&255]).toLowerCase()}function _t(n,e,t){return Math.max(e,Math.min(t,n))}function ov(n,e){return(n%e+e)%e}function $u(n,e,t){return(1-t)*n+t*e}function om(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Yh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function av(n,e){if(e.constructor===Float32Array)return n;let t=Yh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function lv(n,e){if(e.constructor===Float32Array)return n;let t=Yh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var ft=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(_t(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(_t(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ln=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],f=r[o+0],p=r[o+1],g=r[o+2],S=r[o+3];if(h!==S||l!==f||c!==p||u!==g){let d=l*f+c*p+u*g+h*S;d<0&&(f=-f,p=-p,g=-g,S=-S,d=-d);let m=1-a;if(d<.9995){let y=Math.acos(d),C=Math.sin(y);m=Math.sin(m*y)/C,a=Math.sin(a*y)/C,l=l*m+f*a,c=c*m+p*a,u=u*m+g*a,h=h*m+S*a}else{l=l*m+f*a,c=c*m+p*a,u=u*m+g*a,h=h*m+S*a;let y=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=y,c*=y,u*=y,h*=y}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],p=r[o+2],g=r[o+3];return e[t]=a*g+u*h+l*p-c*f,e[t+1]=l*g+u*f+c*h-a*p,e[t+2]=c*g+u*p+a*f-l*h,e[t+3]=u*g-a*h-l*f-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),p=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*p*g,this._y=c*p*h-f*u*g,this._z=c*u*g+f*p*h,this._w=c*u*h-f*p*g;break;case"YXZ":this._x=f*u*h+c*p*g,this._y=c*p*h-f*u*g,this._z=c*u*g-f*p*h,this._w=c*u*h+f*p*g;break;case"ZXY":this._x=f*u*h-c*p*g,this._y=c*p*h+f*u*g,this._z=c*u*g+f*p*h,this._w=c*u*h-f*p*g;break;case"ZYX":this._x=f*u*h-c*p*g,this._y=c*p*h+f*u*g,this._z=c*u*g-f*p*h,this._w=c*u*h+f*p*g;break;case"YZX":this._x=f*u*h+c*p*g,this._y=c*p*h+f*u*g,this._z=c*u*g-f*p*h,this._w=c*u*h-f*p*g;break;case"XZY":this._x=f*u*h-c*p*g,this._y=c*p*h-f*u*g,this._z=c*u*g+f*p*h,this._w=c*u*h+f*p*g;break;default:$e("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=i+a+h;if(f>0){let p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(i>a&&i>h){let p=2*Math.sqrt(1+i-a-h);this._w=(u-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>h){let p=2*Math.sqrt(1+a-i-h);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+h-i-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(_t(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},W=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion($d.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion($d.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(_t(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Yu.copy(this).projectOnVector(e),this.sub(Yu)}reflect(e){return this.sub(Yu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(_t(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Yu=new W,$d=new Ln,et=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],p=i[5],g=i[8],S=s[0],d=s[3],m=s[6],y=s[1],C=s[4],b=s[7],P=s[2],A=s[5],x=s[8];return r[0]=o*S+a*y+l*P,r[3]=o*d+a*C+l*A,r[6]=o*m+a*b+l*x,r[1]=c*S+u*y+h*P,r[4]=c*d+u*C+h*A,r[7]=c*m+u*b+h*x,r[2]=f*S+p*y+g*P,r[5]=f*d+p*C+g*A,r[8]=f*m+p*b+g*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,p=c*r-o*l,g=t*h+i*f+s*p;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let S=1/g;return e[0]=h*S,e[1]=(s*c-u*i)*S,e[2]=(a*i-s*o)*S,e[3]=f*S,e[4]=(u*t-s*l)*S,e[5]=(s*r-a*t)*S,e[6]=p*S,e[7]=(i*l-c*t)*S,e[8]=(o*t-i*r)*S,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return jo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Zu.makeScale(e,t)),this}rotate(e){return jo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Zu.makeRotation(-e)),this}translate(e,t){return jo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Zu.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Zu=new et,Yd=new et().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Zd=new et().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function cv(){let n={enabled:!0,workingColorSpace:ea,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===wt&&(s.r=ds(s.r),s.g=ds(s.g),s.b=ds(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===wt&&(s.r=to(s.r),s.g=to(s.g),s.b=to(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ss?ta:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ea]:{primaries:e,whitePoint:i,transfer:ta,toXYZ:Yd,fromXYZ:Zd,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:qn},outputColorSpaceConfig:{drawingBufferColorSpace:qn}},[qn]:{primaries:e,whitePoint:i,transfer:wt,toXYZ:Yd,fromXYZ:Zd,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:qn}}}),n}var mt=cv();function ds(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function to(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Vr,Hl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Vr===void 0&&(Vr=na("canvas")),Vr.width=e.width,Vr.height=e.height;let s=Vr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Vr}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=na("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ds(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(ds(t[i]/255)*255):t[i]=ds(t[i]);return{data:t,width:e.width,height:e.height}}else return $e("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},uv=0,ro=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:uv++}),this.uuid=Ra(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Ju(s[o].image)):r.push(Ju(s[o]))}else r=Ju(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Ju(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Hl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:($e("Texture: Unable to serialize Texture."),{})}var hv=0,Ku=new W,Qn=class n extends Yi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=$i,s=$i,r=Yn,o=vs,a=ei,l=kn,c=n.DEFAULT_ANISOTROPY,u=Ss){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:hv++}),this.uuid=Ra(),this.name="",this.source=new ro(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ft(0,0),this.repeat=new ft(1,1),this.center=new ft(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new et,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Ku).x}get height(){return this.source.getSize(Ku).y}get depth(){return this.source.getSize(Ku).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){$e(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Fh)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case kl:e.x=e.x-Math.floor(e.x);break;case $i:e.x=e.x<0?0:1;break;case zl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case kl:e.y=e.y-Math.floor(e.y);break;case $i:e.y=e.y<0?0:1;break;case zl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Qn.DEFAULT_IMAGE=null;Qn.DEFAULT_MAPPING=Fh;Qn.DEFAULT_ANISOTROPY=1;var Ot=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],p=l[5],g=l[9],S=l[2],d=l[6],m=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-S)<.01&&Math.abs(g-d)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+S)<.1&&Math.abs(g+d)<.1&&Math.abs(c+p+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let C=(c+1)/2,b=(p+1)/2,P=(m+1)/2,A=(u+f)/4,x=(h+S)/4,T=(g+d)/4;return C>b&&C>P?C<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(C),s=A/i,r=x/i):b>P?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=A/s,r=T/s):P<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),i=x/r,s=T/r),this.set(i,s,r,t),this}let y=Math.sqrt((d-g)*(d-g)+(h-S)*(h-S)+(f-u)*(f-u));return Math.abs(y)<.001&&(y=1),this.x=(d-g)/y,this.y=(h-S)/y,this.z=(f-u)/y,this.w=Math.acos((c+p+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this.w=_t(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this.w=_t(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(_t(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Wl=class extends Yi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Yn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Ot(0,0,e,t),this.scissorTest=!1,this.viewport=new Ot(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Qn({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Yn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new ro(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},li=class extends Wl{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},ia=class extends Qn{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=$i,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Xl=class extends Qn{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=$i,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var vt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,f,p,g,S,d){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,f,p,g,S,d)}set(e,t,i,s,r,o,a,l,c,u,h,f,p,g,S,d){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=h,m[14]=f,m[3]=p,m[7]=g,m[11]=S,m[15]=d,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Gr.setFromMatrixColumn(e,0).length(),r=1/Gr.setFromMatrixColumn(e,1).length(),o=1/Gr.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,p=o*h,g=a*u,S=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=p+g*c,t[5]=f-S*c,t[9]=-a*l,t[2]=S-f*c,t[6]=g+p*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,p=l*h,g=c*u,S=c*h;t[0]=f+S*a,t[4]=g*a-p,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=p*a-g,t[6]=S+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,p=l*h,g=c*u,S=c*h;t[0]=f-S*a,t[4]=-o*h,t[8]=g+p*a,t[1]=p+g*a,t[5]=o*u,t[9]=S-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,p=o*h,g=a*u,S=a*h;t[0]=l*u,t[4]=g*c-p,t[8]=f*c+S,t[1]=l*h,t[5]=S*c+f,t[9]=p*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,p=o*c,g=a*l,S=a*c;t[0]=l*u,t[4]=S-f*h,t[8]=g*h+p,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=p*h+g,t[10]=f-S*h}else if(e.order==="XZY"){let f=o*l,p=o*c,g=a*l,S=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+S,t[5]=o*u,t[9]=p*h-g,t[2]=g*h-p,t[6]=a*u,t[10]=S*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(fv,e,dv)}lookAt(e,t,i){let s=this.elements;return oi.subVectors(e,t),oi.lengthSq()===0&&(oi.z=1),oi.normalize(),Ns.crossVectors(i,oi),Ns.lengthSq()===0&&(Math.abs(i.z)===1?oi.x+=1e-4:oi.z+=1e-4,oi.normalize(),Ns.crossVectors(i,oi)),Ns.normalize(),al.crossVectors(oi,Ns),s[0]=Ns.x,s[4]=al.x,s[8]=oi.x,s[1]=Ns.y,s[5]=al.y,s[9]=oi.y,s[2]=Ns.z,s[6]=al.z,s[10]=oi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],p=i[13],g=i[2],S=i[6],d=i[10],m=i[14],y=i[3],C=i[7],b=i[11],P=i[15],A=s[0],x=s[4],T=s[8],B=s[12],D=s[1],I=s[5],k=s[9],V=s[13],N=s[2],H=s[6],$=s[10],G=s[14],le=s[3],J=s[7],j=s[11],ie=s[15];return r[0]=o*A+a*D+l*N+c*le,r[4]=o*x+a*I+l*H+c*J,r[8]=o*T+a*k+l*$+c*j,r[12]=o*B+a*V+l*G+c*ie,r[1]=u*A+h*D+f*N+p*le,r[5]=u*x+h*I+f*H+p*J,r[9]=u*T+h*k+f*$+p*j,r[13]=u*B+h*V+f*G+p*ie,r[2]=g*A+S*D+d*N+m*le,r[6]=g*x+S*I+d*H+m*J,r[10]=g*T+S*k+d*$+m*j,r[14]=g*B+S*V+d*G+m*ie,r[3]=y*A+C*D+b*N+P*le,r[7]=y*x+C*I+b*H+P*J,r[11]=y*T+C*k+b*$+P*j,r[15]=y*B+C*V+b*G+P*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],p=e[14],g=e[3],S=e[7],d=e[11],m=e[15],y=l*p-c*f,C=a*p-c*h,b=a*f-l*h,P=o*p-c*u,A=o*f-l*u,x=o*h-a*u;return t*(S*y-d*C+m*b)-i*(g*y-d*P+m*A)+s*(g*C-S*P+m*x)-r*(g*b-S*A+d*x)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],p=e[11],g=e[12],S=e[13],d=e[14],m=e[15],y=t*a-i*o,C=t*l-s*o,b=t*c-r*o,P=i*l-s*a,A=i*c-r*a,x=s*c-r*l,T=u*S-h*g,B=u*d-f*g,D=u*m-p*g,I=h*d-f*S,k=h*m-p*S,V=f*m-p*d,N=y*V-C*k+b*I+P*D-A*B+x*T;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/N;return e[0]=(a*V-l*k+c*I)*H,e[1]=(s*k-i*V-r*I)*H,e[2]=(S*x-d*A+m*P)*H,e[3]=(f*A-h*x-p*P)*H,e[4]=(l*D-o*V-c*B)*H,e[5]=(t*V-s*D+r*B)*H,e[6]=(d*b-g*x-m*C)*H,e[7]=(u*x-f*b+p*C)*H,e[8]=(o*k-a*D+c*T)*H,e[9]=(i*D-t*k-r*T)*H,e[10]=(g*A-S*b+m*y)*H,e[11]=(h*b-u*A-p*y)*H,e[12]=(a*B-o*I-l*T)*H,e[13]=(t*I-i*B+s*T)*H,e[14]=(S*C-g*P-d*y)*H,e[15]=(u*P-h*C+f*y)*H,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,p=r*u,g=r*h,S=o*u,d=o*h,m=a*h,y=l*c,C=l*u,b=l*h,P=i.x,A=i.y,x=i.z;return s[0]=(1-(S+m))*P,s[1]=(p+b)*P,s[2]=(g-C)*P,s[3]=0,s[4]=(p-b)*A,s[5]=(1-(f+m))*A,s[6]=(d+y)*A,s[7]=0,s[8]=(g+C)*x,s[9]=(d-y)*x,s[10]=(1-(f+S))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Gr.set(s[0],s[1],s[2]).length(),a=Gr.set(s[4],s[5],s[6]).length(),l=Gr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ci.copy(this);let c=1/o,u=1/a,h=1/l;return Ci.elements[0]*=c,Ci.elements[1]*=c,Ci.elements[2]*=c,Ci.elements[4]*=u,Ci.elements[5]*=u,Ci.elements[6]*=u,Ci.elements[8]*=h,Ci.elements[9]*=h,Ci.elements[10]*=h,t.setFromRotationMatrix(Ci),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=xi,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),f=(t+e)/(t-e),p=(i+s)/(i-s),g,S;if(l)g=r/(o-r),S=o*r/(o-r);else if(a===xi)g=-(o+r)/(o-r),S=-2*o*r/(o-r);else if(a===io)g=-o/(o-r),S=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=S,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=xi,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),f=-(t+e)/(t-e),p=-(i+s)/(i-s),g,S;if(l)g=1/(o-r),S=o/(o-r);else if(a===xi)g=-2/(o-r),S=-(o+r)/(o-r);else if(a===io)g=-1/(o-r),S=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=g,c[14]=S,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Gr=new W,Ci=new vt,fv=new W(0,0,0),dv=new W(1,1,1),Ns=new W,al=new W,oi=new W,Jd=new vt,Kd=new Ln,ms=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],p=s[10];switch(t){case"XYZ":this._y=Math.asin(_t(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-_t(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(_t(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-_t(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(_t(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-_t(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:$e("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Jd.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Jd,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Kd.setFromEuler(this),this.setFromQuaternion(Kd,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ms.DEFAULT_ORDER="XYZ";var oo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},pv=0,jd=new W,Hr=new Ln,ls=new vt,ll=new W,Xo=new W,mv=new W,gv=new Ln,Qd=new W(1,0,0),ep=new W(0,1,0),tp=new W(0,0,1),np={type:"added"},_v={type:"removed"},Wr={type:"childadded",child:null},ju={type:"childremoved",child:null},Nn=class n extends Yi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:pv++}),this.uuid=Ra(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new W,t=new ms,i=new Ln,s=new W(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new vt},normalMatrix:{value:new et}}),this.matrix=new vt,this.matrixWorld=new vt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new oo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Hr.setFromAxisAngle(e,t),this.quaternion.multiply(Hr),this}rotateOnWorldAxis(e,t){return Hr.setFromAxisAngle(e,t),this.quaternion.premultiply(Hr),this}rotateX(e){return this.rotateOnAxis(Qd,e)}rotateY(e){return this.rotateOnAxis(ep,e)}rotateZ(e){return this.rotateOnAxis(tp,e)}translateOnAxis(e,t){return jd.copy(e).applyQuaternion(this.quaternion),this.position.add(jd.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Qd,e)}translateY(e){return this.translateOnAxis(ep,e)}translateZ(e){return this.translateOnAxis(tp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ls.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?ll.copy(e):ll.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Xo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ls.lookAt(Xo,ll,this.up):ls.lookAt(ll,Xo,this.up),this.quaternion.setFromRotationMatrix(ls),s&&(ls.extractRotation(s.matrixWorld),Hr.setFromRotationMatrix(ls),this.quaternion.premultiply(Hr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Ke("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(np),Wr.child=e,this.dispatchEvent(Wr),Wr.child=null):Ke("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(_v),ju.child=e,this.dispatchEvent(ju),ju.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ls.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ls.multiply(e.parent.matrixWorld)),e.applyMatrix4(ls),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(np),Wr.child=e,this.dispatchEvent(Wr),Wr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Xo,e,mv),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Xo,gv,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),p=o(e.animations),g=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),p.length>0&&(i.animations=p),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Nn.DEFAULT_UP=new W(0,1,0);Nn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Nn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var xn=class extends Nn{constructor(){super(),this.isGroup=!0,this.type="Group"}},xv={type:"move"},ao=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new xn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new xn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new W,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new W),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new xn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new W,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new W,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let S of e.hand.values()){let d=t.getJointPose(S,i),m=this._getHandJoint(c,S);d!==null&&(m.matrix.fromArray(d.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=d.radius),m.visible=d!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),p=.02,g=.005;c.inputState.pinching&&f>p+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=p-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(xv)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new xn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},am={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ds={h:0,s:0,l:0},cl={h:0,s:0,l:0};function Qu(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var je=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=qn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,mt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=mt.workingColorSpace){return this.r=e,this.g=t,this.b=i,mt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=mt.workingColorSpace){if(e=ov(e,1),t=_t(t,0,1),i=_t(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Qu(o,r,e+1/3),this.g=Qu(o,r,e),this.b=Qu(o,r,e-1/3)}return mt.colorSpaceToWorking(this,s),this}setStyle(e,t=qn){function i(r){r!==void 0&&parseFloat(r)<1&&$e("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:$e("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);$e("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=qn){let i=am[e.toLowerCase()];return i!==void 0?this.setHex(i,t):$e("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ds(e.r),this.g=ds(e.g),this.b=ds(e.b),this}copyLinearToSRGB(e){return this.r=to(e.r),this.g=to(e.g),this.b=to(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=qn){return mt.workingToColorSpace(Bn.copy(this),e),Math.round(_t(Bn.r*255,0,255))*65536+Math.round(_t(Bn.g*255,0,255))*256+Math.round(_t(Bn.b*255,0,255))}getHexString(e=qn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=mt.workingColorSpace){mt.workingToColorSpace(Bn.copy(this),t);let i=Bn.r,s=Bn.g,r=Bn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=mt.workingColorSpace){return mt.workingToColorSpace(Bn.copy(this),t),e.r=Bn.r,e.g=Bn.g,e.b=Bn.b,e}getStyle(e=qn){mt.workingToColorSpace(Bn.copy(this),e);let t=Bn.r,i=Bn.g,s=Bn.b;return e!==qn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Ds),this.setHSL(Ds.h+e,Ds.s+t,Ds.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Ds),e.getHSL(cl);let i=$u(Ds.h,cl.h,t),s=$u(Ds.s,cl.s,t),r=$u(Ds.l,cl.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Bn=new je;je.NAMES=am;var sa=class extends Nn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ms,this.environmentIntensity=1,this.environmentRotation=new ms,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ri=new W,cs=new W,eh=new W,us=new W,Xr=new W,qr=new W,ip=new W,th=new W,nh=new W,ih=new W,sh=new Ot,rh=new Ot,oh=new Ot,Bs=class n{constructor(e=new W,t=new W,i=new W){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Ri.subVectors(e,t),s.cross(Ri);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Ri.subVectors(s,t),cs.subVectors(i,t),eh.subVectors(e,t);let o=Ri.dot(Ri),a=Ri.dot(cs),l=Ri.dot(eh),c=cs.dot(cs),u=cs.dot(eh),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,p=(c*l-a*u)*f,g=(o*u-a*l)*f;return r.set(1-p-g,g,p)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,us)===null?!1:us.x>=0&&us.y>=0&&us.x+us.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,us)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,us.x),l.addScaledVector(o,us.y),l.addScaledVector(a,us.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return sh.setScalar(0),rh.setScalar(0),oh.setScalar(0),sh.fromBufferAttribute(e,t),rh.fromBufferAttribute(e,i),oh.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(sh,r.x),o.addScaledVector(rh,r.y),o.addScaledVector(oh,r.z),o}static isFrontFacing(e,t,i,s){return Ri.subVectors(i,t),cs.subVectors(e,t),Ri.cross(cs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ri.subVectors(this.c,this.b),cs.subVectors(this.a,this.b),Ri.cross(cs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Xr.subVectors(s,i),qr.subVectors(r,i),th.subVectors(e,i);let l=Xr.dot(th),c=qr.dot(th);if(l<=0&&c<=0)return t.copy(i);nh.subVectors(e,s);let u=Xr.dot(nh),h=qr.dot(nh);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Xr,o);ih.subVectors(e,r);let p=Xr.dot(ih),g=qr.dot(ih);if(g>=0&&p<=g)return t.copy(r);let S=p*c-l*g;if(S<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(i).addScaledVector(qr,a);let d=u*g-p*h;if(d<=0&&h-u>=0&&p-g>=0)return ip.subVectors(r,s),a=(h-u)/(h-u+(p-g)),t.copy(s).addScaledVector(ip,a);let m=1/(d+S+f);return o=S*m,a=f*m,t.copy(i).addScaledVector(Xr,o).addScaledVector(qr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Zi=class{constructor(e=new W(1/0,1/0,1/0),t=new W(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Pi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Pi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Pi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Pi):Pi.fromBufferAttribute(r,o),Pi.applyMatrix4(e.matrixWorld),this.expandByPoint(Pi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),ul.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),ul.copy(i.boundingBox)),ul.applyMatrix4(e.matrixWorld),this.union(ul)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Pi),Pi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(qo),hl.subVectors(this.max,qo),$r.subVectors(e.a,qo),Yr.subVectors(e.b,qo),Zr.subVectors(e.c,qo),Us.subVectors(Yr,$r),Fs.subVectors(Zr,Yr),nr.subVectors($r,Zr);let t=[0,-Us.z,Us.y,0,-Fs.z,Fs.y,0,-nr.z,nr.y,Us.z,0,-Us.x,Fs.z,0,-Fs.x,nr.z,0,-nr.x,-Us.y,Us.x,0,-Fs.y,Fs.x,0,-nr.y,nr.x,0];return!ah(t,$r,Yr,Zr,hl)||(t=[1,0,0,0,1,0,0,0,1],!ah(t,$r,Yr,Zr,hl))?!1:(fl.crossVectors(Us,Fs),t=[fl.x,fl.y,fl.z],ah(t,$r,Yr,Zr,hl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Pi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Pi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(hs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),hs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),hs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),hs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),hs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),hs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),hs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),hs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(hs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},hs=[new W,new W,new W,new W,new W,new W,new W,new W],Pi=new W,ul=new Zi,$r=new W,Yr=new W,Zr=new W,Us=new W,Fs=new W,nr=new W,qo=new W,hl=new W,fl=new W,ir=new W;function ah(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){ir.fromArray(n,r);let a=s.x*Math.abs(ir.x)+s.y*Math.abs(ir.y)+s.z*Math.abs(ir.z),l=e.dot(ir),c=t.dot(ir),u=i.dot(ir);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var dn=new W,dl=new ft,vv=0,on=class extends Yi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:vv++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=tm,this.updateRanges=[],this.gpuType=yi,this.version=0,this._normalizationScale=e!==void 0?Yh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)dl.fromBufferAttribute(this,t),dl.applyMatrix3(e),this.setXY(t,dl.x,dl.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)dn.fromBufferAttribute(this,t),dn.applyMatrix3(e),this.setXYZ(t,dn.x,dn.y,dn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)dn.fromBufferAttribute(this,t),dn.applyMatrix4(e),this.setXYZ(t,dn.x,dn.y,dn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)dn.fromBufferAttribute(this,t),dn.applyNormalMatrix(e),this.setXYZ(t,dn.x,dn.y,dn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)dn.fromBufferAttribute(this,t),dn.transformDirection(e),this.setXYZ(t,dn.x,dn.y,dn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):av(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):lv(e,this.array)}};var ra=class extends on{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var oa=class extends on{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Jt=class extends on{constructor(e,t,i){super(new Float32Array(e),t,i)}},yv=new Zi,$o=new W,lh=new W,gs=class{constructor(e=new W,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):yv.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;$o.subVectors(e,this.center);let t=$o.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector($o,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(lh.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint($o.copy(e.center).add(lh)),this.expandByPoint($o.copy(e.center).sub(lh))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Sv=0,_i=new vt,ch=new Nn,Jr=new W,ai=new Zi,Yo=new Zi,Rn=new W,Dn=class n extends Yi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Sv++}),this.uuid=Ra(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(sv(e)?oa:ra)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new et().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return _i.makeRotationFromQuaternion(e),this.applyMatrix4(_i),this}rotateX(e){return _i.makeRotationX(e),this.applyMatrix4(_i),this}rotateY(e){return _i.makeRotationY(e),this.applyMatrix4(_i),this}rotateZ(e){return _i.makeRotationZ(e),this.applyMatrix4(_i),this}translate(e,t,i){return _i.makeTranslation(e,t,i),this.applyMatrix4(_i),this}scale(e,t,i){return _i.makeScale(e,t,i),this.applyMatrix4(_i),this}lookAt(e){return ch.lookAt(e),ch.updateMatrix(),this.applyMatrix4(ch.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Jr).negate(),this.translate(Jr.x,Jr.y,Jr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Jt(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&$e("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Zi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ke("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new W(-1/0,-1/0,-1/0),new W(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];ai.setFromBufferAttribute(r),this.morphTargetsRelative?(Rn.addVectors(this.boundingBox.min,ai.min),this.boundingBox.expandByPoint(Rn),Rn.addVectors(this.boundingBox.max,ai.max),this.boundingBox.expandByPoint(Rn)):(this.boundingBox.expandByPoint(ai.min),this.boundingBox.expandByPoint(ai.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ke('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new gs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ke("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new W,1/0);return}if(e){let i=this.boundingSphere.center;if(ai.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Yo.setFromBufferAttribute(a),this.morphTargetsRelative?(Rn.addVectors(ai.min,Yo.min),ai.expandByPoint(Rn),Rn.addVectors(ai.max,Yo.max),ai.expandByPoint(Rn)):(ai.expandByPoint(Yo.min),ai.expandByPoint(Yo.max))}ai.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Rn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Rn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Rn.fromBufferAttribute(a,c),l&&(Jr.fromBufferAttribute(e,c),Rn.add(Jr)),s=Math.max(s,i.distanceToSquared(Rn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Ke('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Ke("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new on(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let B=0;B<i.count;B++)a[B]=new W,l[B]=new W;let u=new W,h=new W,f=new W,p=new ft,g=new ft,S=new ft,d=new W,m=new W;function y(B,D,I){c[B]=c[D]=c[I]=1,u.fromBufferAttribute(i,B),h.fromBufferAttribute(i,D),f.fromBufferAttribute(i,I),p.fromBufferAttribute(r,B),g.fromBufferAttribute(r,D),S.fromBufferAttribute(r,I),h.sub(u),f.sub(u),g.sub(p),S.sub(p);let k=1/(g.x*S.y-S.x*g.y);isFinite(k)&&(d.copy(h).multiplyScalar(S.y).addScaledVector(f,-g.y).multiplyScalar(k),m.copy(f).multiplyScalar(g.x).addScaledVector(h,-S.x).multiplyScalar(k),a[B].add(d),a[D].add(d),a[I].add(d),l[B].add(m),l[D].add(m),l[I].add(m))}let C=this.groups;C.length===0&&(C=[{start:0,count:e.count}]);for(let B=0,D=C.length;B<D;++B){let I=C[B],k=I.start,V=I.count;for(let N=k,H=k+V;N<H;N+=3)y(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let b=new W,P=new W,A=new W,x=new W;function T(B){A.fromBufferAttribute(s,B),x.copy(A);let D=a[B];b.copy(D),b.sub(A.multiplyScalar(A.dot(D))).normalize(),P.crossVectors(x,D);let k=P.dot(l[B])<0?-1:1;o.setXYZW(B,b.x,b.y,b.z,k)}for(let B=0,D=i.count;B<D;++B)c[B]&&T(B);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new on(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,p=i.count;f<p;f++)i.setXYZ(f,0,0,0);let s=new W,r=new W,o=new W,a=new W,l=new W,c=new W,u=new W,h=new W;if(e)for(let f=0,p=e.count;f<p;f+=3){let g=e.getX(f+0),S=e.getX(f+1),d=e.getX(f+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,S),o.fromBufferAttribute(t,d),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,S),c.fromBufferAttribute(i,d),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(S,l.x,l.y,l.z),i.setXYZ(d,c.x,c.y,c.z)}else for(let f=0,p=t.count;f<p;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Rn.fromBufferAttribute(e,t),Rn.normalize(),e.setXYZ(t,Rn.x,Rn.y,Rn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),p=0,g=0;for(let S=0,d=l.length;S<d;S++){a.isInterleavedBufferAttribute?p=l[S]*a.data.stride+a.offset:p=l[S]*u;for(let m=0;m<u;m++)f[g++]=c[p++]}return new on(f,u,h)}if(this.index===null)return $e("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],p=e(f,i);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let p=c[h];u.push(p.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,p=h.length;f<p;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var uh=new W,Mv=new W,bv=new et,Ii=class{constructor(e=new W(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=uh.subVectors(i,t).cross(Mv.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(uh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||bv.getNormalMatrix(e),s=this.coplanarPoint(uh).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},wv=0,Ji=class extends Yi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:wv++}),this.uuid=Ra(),this.name="",this.type="Material",this.blending=go,this.side=Xs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Eh,this.blendDst=Ch,this.blendEquation=hr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new je(0,0,0),this.blendAlpha=0,this.depthFunc=no,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Zp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Il,this.stencilZFail=Il,this.stencilZPass=Il,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){$e(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new je().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Ii().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new ft().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ft().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var fs=new W,hh=new W,pl=new W,ml=new W,lo=class{constructor(e=new W,t=new W(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,fs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=fs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(fs.copy(this.origin).addScaledVector(this.direction,t),fs.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){hh.copy(e).add(t).multiplyScalar(.5),pl.copy(t).sub(e).normalize(),ml.copy(this.origin).sub(hh);let r=e.distanceTo(t)*.5,o=-this.direction.dot(pl),a=ml.dot(this.direction),l=-ml.dot(pl),c=ml.lengthSq(),u=Math.abs(1-o*o),h,f,p,g;if(u>0)if(h=o*l-a,f=o*a-l,g=r*u,h>=0)if(f>=-g)if(f<=g){let S=1/u;h*=S,f*=S,p=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f<=-g?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),p=-h*h+f*(f+2*l)+c):f<=g?(h=0,f=Math.min(Math.max(-r,-l),r),p=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),p=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(hh).addScaledVector(pl,f),p}intersectSphere(e,t){if(e.radius<0)return null;fs.subVectors(e.center,this.origin);let i=fs.dot(this.direction),s=fs.dot(fs)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,fs)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,f=e.y-o.y,p=e.z-o.z,g=t.x-o.x,S=t.y-o.y,d=t.z-o.z,m=i.x-o.x,y=i.y-o.y,C=i.z-o.z,b=Math.abs(l),P=Math.abs(c),A=Math.abs(u),x,T,B,D,I,k,V,N,H,$,G,le;if(b>=P&&b>=A?(B=l,k=h,H=g,le=m,l>=0?(x=c,T=u,D=f,I=p,V=S,N=d,$=y,G=C):(x=u,T=c,D=p,I=f,V=d,N=S,$=C,G=y)):P>=A?(B=c,k=f,H=S,le=y,c>=0?(x=u,T=l,D=p,I=h,V=d,N=g,$=C,G=m):(x=l,T=u,D=h,I=p,V=g,N=d,$=m,G=C)):(B=u,k=p,H=d,le=C,u>=0?(x=l,T=c,D=h,I=f,V=g,N=S,$=m,G=y):(x=c,T=l,D=f,I=h,V=S,N=g,$=y,G=m)),B===0)return null;let J=x/B,j=T/B,ie=1/B,he=D-J*k,ue=I-j*k,Q=V-J*H,pe=N-j*H,xe=$-J*le,Ee=G-j*le,Me=xe*pe-Ee*Q,He=he*Ee-ue*xe,it=Q*ue-pe*he;if(s){if(Me<0||He<0||it<0)return null}else if((Me<0||He<0||it<0)&&(Me>0||He>0||it>0))return null;let Ve=Me+He+it;if(Ve===0)return null;let ct=ie*(Me*k+He*H+it*le);return(Ve>0?ct<0:ct>0)?null:this.at(ct/Ve,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ks=class extends Ji{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ms,this.combine=Rh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},sp=new vt,sr=new lo,gl=new gs,rp=new W,_l=new W,xl=new W,vl=new W,fh=new W,yl=new W,op=new W,Sl=new W,Wt=class extends Nn{constructor(e=new Dn,t=new ks){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){yl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(fh.fromBufferAttribute(h,e),o?yl.addScaledVector(fh,u):yl.addScaledVector(fh.sub(t),u))}t.add(yl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),gl.copy(i.boundingSphere),gl.applyMatrix4(r),sr.copy(e.ray).recast(e.near),!(gl.containsPoint(sr.origin)===!1&&(sr.intersectSphere(gl,rp)===null||sr.origin.distanceToSquared(rp)>(e.far-e.near)**2))&&(sp.copy(r).invert(),sr.copy(e.ray).applyMatrix4(sp),!(i.boundingBox!==null&&sr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,sr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,S=f.length;g<S;g++){let d=f[g],m=o[d.materialIndex],y=Math.max(d.start,p.start),C=Math.min(a.count,Math.min(d.start+d.count,p.start+p.count));for(let b=y,P=C;b<P;b+=3){let A=a.getX(b),x=a.getX(b+1),T=a.getX(b+2);s=Ml(this,m,e,i,c,u,h,A,x,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=d.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),S=Math.min(a.count,p.start+p.count);for(let d=g,m=S;d<m;d+=3){let y=a.getX(d),C=a.getX(d+1),b=a.getX(d+2);s=Ml(this,o,e,i,c,u,h,y,C,b),s&&(s.faceIndex=Math.floor(d/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,S=f.length;g<S;g++){let d=f[g],m=o[d.materialIndex],y=Math.max(d.start,p.start),C=Math.min(l.count,Math.min(d.start+d.count,p.start+p.count));for(let b=y,P=C;b<P;b+=3){let A=b,x=b+1,T=b+2;s=Ml(this,m,e,i,c,u,h,A,x,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=d.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),S=Math.min(l.count,p.start+p.count);for(let d=g,m=S;d<m;d+=3){let y=d,C=d+1,b=d+2;s=Ml(this,o,e,i,c,u,h,y,C,b),s&&(s.faceIndex=Math.floor(d/3),t.push(s))}}}};function Tv(n,e,t,i,s,r,o,a){let l;if(e.side===Zn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Xs,a),l===null)return null;Sl.copy(a),Sl.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Sl);return c<t.near||c>t.far?null:{distance:c,point:Sl.clone(),object:n}}function Ml(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,_l),n.getVertexPosition(l,xl),n.getVertexPosition(c,vl);let u=Tv(n,e,t,i,_l,xl,vl,op);if(u){let h=new W;Bs.getBarycoord(op,_l,xl,vl,h),s&&(u.uv=Bs.getInterpolatedAttribute(s,a,l,c,h,new ft)),r&&(u.uv1=Bs.getInterpolatedAttribute(r,a,l,c,h,new ft)),o&&(u.normal=Bs.getInterpolatedAttribute(o,a,l,c,h,new W),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new W,materialIndex:0};Bs.getNormal(_l,xl,vl,f.normal),u.face=f,u.barycoord=h}return u}var or=class extends Qn{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Pn,u=Pn,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var aa=class extends on{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Kr=new vt,ap=new vt,bl=[],lp=new Zi,Av=new vt,Zo=new Wt,Jo=new gs,la=class extends Wt{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new aa(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,Av)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Zi),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Kr),lp.copy(e.boundingBox).applyMatrix4(Kr),this.boundingBox.union(lp)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new gs),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Kr),Jo.copy(e.boundingSphere).applyMatrix4(Kr),this.boundingSphere.union(Jo)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){let i=this.matrixWorld,s=this.count;if(Zo.geometry=this.geometry,Zo.material=this.material,Zo.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Jo.copy(this.boundingSphere),Jo.applyMatrix4(i),e.ray.intersectsSphere(Jo)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Kr),ap.multiplyMatrices(i,Kr),Zo.matrixWorld=ap,Zo.raycast(e,bl);for(let o=0,a=bl.length;o<a;o++){let l=bl[o];l.instanceId=r,l.object=this,t.push(l)}bl.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new aa(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new or(new Float32Array(s*this.count),s,this.count,vo,yi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},rr=new gs,Ev=new ft(.5,.5),wl=new W,zs=class{constructor(e=new Ii,t=new Ii,i=new Ii,s=new Ii,r=new Ii,o=new Ii){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=xi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],p=r[7],g=r[8],S=r[9],d=r[10],m=r[11],y=r[12],C=r[13],b=r[14],P=r[15];if(s[0].setComponents(c-o,p-u,m-g,P-y).normalize(),s[1].setComponents(c+o,p+u,m+g,P+y).normalize(),s[2].setComponents(c+a,p+h,m+S,P+C).normalize(),s[3].setComponents(c-a,p-h,m-S,P-C).normalize(),i)s[4].setComponents(l,f,d,b).normalize(),s[5].setComponents(c-l,p-f,m-d,P-b).normalize();else if(s[4].setComponents(c-l,p-f,m-d,P-b).normalize(),t===xi)s[5].setComponents(c+l,p+f,m+d,P+b).normalize();else if(t===io)s[5].setComponents(l,f,d,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),rr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),rr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(rr)}intersectsSprite(e){rr.center.set(0,0,0);let t=Ev.distanceTo(e.center);return rr.radius=.7071067811865476+t,rr.applyMatrix4(e.matrixWorld),this.intersectsSphere(rr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(wl.x=s.normal.x>0?e.max.x:e.min.x,wl.y=s.normal.y>0?e.max.y:e.min.y,wl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(wl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},cp=new vt,ql=class n{constructor(){this.coordinateSystem=xi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];cp.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new zs),i[s].setFromProjectionMatrix(cp,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new zs),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var co=class extends Ji{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new je(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},$l=new W,Yl=new W,up=new vt,Ko=new lo,Tl=new gs,dh=new W,hp=new W,Zl=class extends Nn{constructor(e=new Dn,t=new co){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)$l.fromBufferAttribute(t,s-1),Yl.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=$l.distanceTo(Yl);e.setAttribute("lineDistance",new Jt(i,1))}else $e("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Tl.copy(i.boundingSphere),Tl.applyMatrix4(s),Tl.radius+=r,e.ray.intersectsSphere(Tl)===!1)return;up.copy(s).invert(),Ko.copy(e.ray).applyMatrix4(up);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){let p=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let S=p,d=g-1;S<d;S+=c){let m=u.getX(S),y=u.getX(S+1),C=Al(this,e,Ko,l,m,y,S);C&&t.push(C)}if(this.isLineLoop){let S=u.getX(g-1),d=u.getX(p),m=Al(this,e,Ko,l,S,d,g-1);m&&t.push(m)}}else{let p=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let S=p,d=g-1;S<d;S+=c){let m=Al(this,e,Ko,l,S,S+1,S);m&&t.push(m)}if(this.isLineLoop){let S=Al(this,e,Ko,l,g-1,p,g-1);S&&t.push(S)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Al(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if($l.fromBufferAttribute(a,s),Yl.fromBufferAttribute(a,r),t.distanceSqToSegment($l,Yl,dh,hp)>i)return;dh.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(dh);if(!(c<e.near||c>e.far))return{distance:c,point:hp.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var fp=new W,dp=new W,ca=class extends Zl{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)fp.fromBufferAttribute(t,s),dp.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+fp.distanceTo(dp);e.setAttribute("lineDistance",new Jt(i,1))}else $e("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ua=class extends Qn{constructor(e=[],t=fr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var _s=class extends Qn{constructor(e,t,i=Ni,s,r,o,a=Pn,l=Pn,c,u=ps,h=1){if(u!==ps&&u!==ys)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ro(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},ha=class extends _s{constructor(e,t=Ni,i=fr,s,r,o=Pn,a=Pn,l,c=ps){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},fa=class extends Qn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},uo=class n extends Dn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,p=0;g("z","y","x",-1,-1,i,t,e,o,r,0),g("z","y","x",1,-1,i,t,-e,o,r,1),g("x","z","y",1,1,e,i,t,s,o,2),g("x","z","y",1,-1,e,i,-t,s,o,3),g("x","y","z",1,-1,e,t,i,s,r,4),g("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Jt(c,3)),this.setAttribute("normal",new Jt(u,3)),this.setAttribute("uv",new Jt(h,2));function g(S,d,m,y,C,b,P,A,x,T,B){let D=b/x,I=P/T,k=b/2,V=P/2,N=A/2,H=x+1,$=T+1,G=0,le=0,J=new W;for(let j=0;j<$;j++){let ie=j*I-V;for(let he=0;he<H;he++){let ue=he*D-k;J[S]=ue*y,J[d]=ie*C,J[m]=N,c.push(J.x,J.y,J.z),J[S]=0,J[d]=0,J[m]=A>0?1:-1,u.push(J.x,J.y,J.z),h.push(he/x),h.push(1-j/T),G+=1}}for(let j=0;j<T;j++)for(let ie=0;ie<x;ie++){let he=f+ie+H*j,ue=f+ie+H*(j+1),Q=f+(ie+1)+H*(j+1),pe=f+(ie+1)+H*j;l.push(he,ue,pe),l.push(ue,Q,pe),le+=6}a.addGroup(p,le,B),p+=le,f+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Li=class n extends Dn{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],f=[],p=[],g=0,S=[],d=i/2,m=0;y(),o===!1&&(e>0&&C(!0),t>0&&C(!1)),this.setIndex(u),this.setAttribute("position",new Jt(h,3)),this.setAttribute("normal",new Jt(f,3)),this.setAttribute("uv",new Jt(p,2));function y(){let b=new W,P=new W,A=0,x=(t-e)/i;for(let T=0;T<=r;T++){let B=[],D=T/r,I=D*(t-e)+e;for(let k=0;k<=s;k++){let V=k/s,N=V*l+a,H=Math.sin(N),$=Math.cos(N);P.x=I*H,P.y=-D*i+d,P.z=I*$,h.push(P.x,P.y,P.z),b.set(H,x,$).normalize(),f.push(b.x,b.y,b.z),p.push(V,1-D),B.push(g++)}S.push(B)}for(let T=0;T<s;T++)for(let B=0;B<r;B++){let D=S[B][T],I=S[B+1][T],k=S[B+1][T+1],V=S[B][T+1];(e>0||B!==0)&&(u.push(D,I,V),A+=3),(t>0||B!==r-1)&&(u.push(I,k,V),A+=3)}c.addGroup(m,A,0),m+=A}function C(b){let P=g,A=new ft,x=new W,T=0,B=b===!0?e:t,D=b===!0?1:-1;for(let k=1;k<=s;k++)h.push(0,d*D,0),f.push(0,D,0),p.push(.5,.5),g++;let I=g;for(let k=0;k<=s;k++){let N=k/s*l+a,H=Math.cos(N),$=Math.sin(N);x.x=B*$,x.y=d*D,x.z=B*H,h.push(x.x,x.y,x.z),f.push(0,D,0),A.x=H*.5+.5,A.y=$*.5*D+.5,p.push(A.x,A.y),g++}for(let k=0;k<s;k++){let V=P+k,N=I+k;b===!0?u.push(N,N+1,V):u.push(N+1,N,V),T+=3}c.addGroup(m,T,b===!0?1:2),m+=T}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},xs=class n extends Li{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var ar=class n extends Dn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,p=[],g=[],S=[],d=[];for(let m=0;m<u;m++){let y=m*f-o;for(let C=0;C<c;C++){let b=C*h-r;g.push(b,-y,0),S.push(0,0,1),d.push(C/a),d.push(1-m/l)}}for(let m=0;m<l;m++)for(let y=0;y<a;y++){let C=y+c*m,b=y+c*(m+1),P=y+1+c*(m+1),A=y+1+c*m;p.push(C,b,A),p.push(b,P,A)}this.setIndex(p),this.setAttribute("position",new Jt(g,3)),this.setAttribute("normal",new Jt(S,3)),this.setAttribute("uv",new Jt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Vs=class n extends Dn{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new W,f=new W,p=[],g=[],S=[],d=[];for(let m=0;m<=i;m++){let y=[],C=m/i,b=o+C*a,P=e*Math.cos(b),A=Math.sqrt(e*e-P*P),x=0;m===0&&o===0?x=.5/t:m===i&&l===Math.PI&&(x=-.5/t);for(let T=0;T<=t;T++){let B=T/t,D=s+B*r;h.x=-A*Math.cos(D),h.y=P,h.z=A*Math.sin(D),g.push(h.x,h.y,h.z),f.copy(h).normalize(),S.push(f.x,f.y,f.z),d.push(B+x,1-C),y.push(c++)}u.push(y)}for(let m=0;m<i;m++)for(let y=0;y<t;y++){let C=u[m][y+1],b=u[m][y],P=u[m+1][y],A=u[m+1][y+1];(m!==0||o>0)&&p.push(C,b,A),(m!==i-1||l<Math.PI)&&p.push(b,P,A)}this.setIndex(p),this.setAttribute("position",new Jt(g,3)),this.setAttribute("normal",new Jt(S,3)),this.setAttribute("uv",new Jt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var da=class n extends Dn{constructor(e=1,t=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],f=new W,p=new W,g=new W;for(let S=0;S<=i;S++){let d=o+S/i*a;for(let m=0;m<=s;m++){let y=m/s*r;p.x=(e+t*Math.cos(d))*Math.cos(y),p.y=(e+t*Math.cos(d))*Math.sin(y),p.z=t*Math.sin(d),c.push(p.x,p.y,p.z),f.x=e*Math.cos(y),f.y=e*Math.sin(y),g.subVectors(p,f).normalize(),u.push(g.x,g.y,g.z),h.push(m/s),h.push(S/i)}}for(let S=1;S<=i;S++)for(let d=1;d<=s;d++){let m=(s+1)*S+d-1,y=(s+1)*(S-1)+d-1,C=(s+1)*(S-1)+d,b=(s+1)*S+d;l.push(m,y,b),l.push(y,C,b)}this.setIndex(l),this.setAttribute("position",new Jt(c,3)),this.setAttribute("normal",new Jt(u,3)),this.setAttribute("uv",new Jt(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};var pa=class extends Ji{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new je(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}};function pr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(pp(s))s.isRenderTargetTexture?($e("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(pp(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function zn(n){let e={};for(let t=0;t<n.length;t++){let i=pr(n[t]);for(let s in i)e[s]=i[s]}return e}function pp(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Cv(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Zh(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:mt.workingColorSpace}var lm={clone:pr,merge:zn},Rv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Pv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,vi=class extends Ji{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Rv,this.fragmentShader=Pv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=pr(e.uniforms),this.uniformsGroups=Cv(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new je().setHex(s.value);break;case"v2":this.uniforms[i].value=new ft().fromArray(s.value);break;case"v3":this.uniforms[i].value=new W().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Ot().fromArray(s.value);break;case"m3":this.uniforms[i].value=new et().fromArray(s.value);break;case"m4":this.uniforms[i].value=new vt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Jl=class extends vi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},lr=class extends Ji{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new je(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new je(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Jc,this.normalScale=new ft(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ms,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Kl=class extends Ji{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=$p,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},jl=class extends Ji{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function jr(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function El(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Gs=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ql=class extends Gs{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:gh,endingEnd:gh}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case _h:r=e,a=2*t-i;break;case xh:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case _h:o=e,l=2*i-t;break;case xh:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,p=this._weightNext,g=(i-t)/(s-t),S=g*g,d=S*g,m=-f*d+2*f*S-f*g,y=(1+f)*d+(-1.5-2*f)*S+(-.5+f)*g+1,C=(-1-p)*d+(1.5+p)*S+.5*g,b=p*d-p*S;for(let P=0;P!==a;++P)r[P]=m*o[u+P]+y*o[c+P]+C*o[l+P]+b*o[h+P];return r}},ec=class extends Gs{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},tc=class extends Gs{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},nc=class extends Gs{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let g=(i-t)/(s-t),S=1-g;for(let d=0;d!==a;++d)r[d]=o[c+d]*S+o[l+d]*g;return r}let f=a*2,p=e-1;for(let g=0;g!==a;++g){let S=o[c+g],d=o[l+g],m=p*f+g*2,y=h[m],C=h[m+1],b=e*f+g*2,P=u[b],A=u[b+1],x=Lv(i,t,y,P,s);r[g]=cm(x,S,C,A,d)}return r}};function cm(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function Iv(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function Lv(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=cm(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=Iv(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ci=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=jr(t,this.TimeBufferType),this.values=jr(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:jr(e.times,Array),values:jr(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),El(e.settings)&&(i.settings={inTangents:jr(e.settings.inTangents,Array),outTangents:jr(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new tc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new ec(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Ql(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new nc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Qo:t=this.InterpolantFactoryMethodDiscrete;break;case Vl:t=this.InterpolantFactoryMethodLinear;break;case Pl:t=this.InterpolantFactoryMethodSmooth;break;case mh:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return $e("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Qo;case this.InterpolantFactoryMethodLinear:return Vl;case this.InterpolantFactoryMethodSmooth:return Pl;case this.InterpolantFactoryMethodBezier:return mh}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;El(this.settings)&&(mp(this.settings.inTangents,e),mp(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;El(this.settings)&&(gp(this.settings.inTangents,e),gp(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Ke("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Ke("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Ke("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Ke("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&rv(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Ke("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Pl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,f=h-i,p=h+i;for(let g=0;g!==i;++g){let S=t[h+g];if(S!==t[f+g]||S!==t[p+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,f=o*i;for(let p=0;p!==i;++p)t[f+p]=t[h+p]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,El(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function mp(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function gp(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}ci.prototype.ValueTypeName="";ci.prototype.TimeBufferType=Float32Array;ci.prototype.ValueBufferType=Float32Array;ci.prototype.DefaultInterpolation=Vl;var Hs=class extends ci{constructor(e,t,i){super(e,t,i)}};Hs.prototype.ValueTypeName="bool";Hs.prototype.ValueBufferType=Array;Hs.prototype.DefaultInterpolation=Qo;Hs.prototype.InterpolantFactoryMethodLinear=void 0;Hs.prototype.InterpolantFactoryMethodSmooth=void 0;var ic=class extends ci{constructor(e,t,i,s){super(e,t,i,s)}};ic.prototype.ValueTypeName="color";var sc=class extends ci{constructor(e,t,i,s){super(e,t,i,s)}};sc.prototype.ValueTypeName="number";var rc=class extends Gs{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Ln.slerpFlat(r,0,o,c-a,o,c,l);return r}},ma=class extends ci{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new rc(this.times,this.values,this.getValueSize(),e)}};ma.prototype.ValueTypeName="quaternion";ma.prototype.InterpolantFactoryMethodSmooth=void 0;var Ws=class extends ci{constructor(e,t,i){super(e,t,i)}};Ws.prototype.ValueTypeName="string";Ws.prototype.ValueBufferType=Array;Ws.prototype.DefaultInterpolation=Qo;Ws.prototype.InterpolantFactoryMethodLinear=void 0;Ws.prototype.InterpolantFactoryMethodSmooth=void 0;var oc=class extends ci{constructor(e,t,i,s){super(e,t,i,s)}};oc.prototype.ValueTypeName="vector";var ac=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let p=c[h],g=c[h+1];if(p.global&&(p.lastIndex=0),p.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},um=new ac,lc=class{constructor(e){this.manager=e!==void 0?e:um,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};lc.DEFAULT_MATERIAL_NAME="__DEFAULT";var ho=class extends Nn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new je(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},ga=class extends ho{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new je(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},ph=new vt,_p=new W,xp=new W,cc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ft(512,512),this.mapType=kn,this.map=null,this.mapPass=null,this.matrix=new vt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new zs,this._frameExtents=new ft(1,1),this._viewportCount=1,this._viewports=[new Ot(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;_p.setFromMatrixPosition(e.matrixWorld),t.position.copy(_p),xp.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(xp),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){ph.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(ph,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===io||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(ph)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Cl=new W,Rl=new Ln,qi=new W,_a=class extends Nn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new vt,this.projectionMatrix=new vt,this.projectionMatrixInverse=new vt,this.coordinateSystem=xi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Cl,Rl,qi),qi.x===1&&qi.y===1&&qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Cl,Rl,qi.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Cl,Rl,qi),qi.x===1&&qi.y===1&&qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Cl,Rl,qi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Os=new W,vp=new ft,yp=new ft,$n=class extends _a{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Gl*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(qu*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Gl*2*Math.atan(Math.tan(qu*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Os.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Os.x,Os.y).multiplyScalar(-e/Os.z),Os.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Os.x,Os.y).multiplyScalar(-e/Os.z)}getViewSize(e,t){return this.getViewBounds(e,vp,yp),t.subVectors(yp,vp)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(qu*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var xa=class extends _a{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},vh=class extends cc{constructor(){super(new xa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},fo=class extends ho{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.target=new Nn,this.shadow=new vh}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},va=class extends ho{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var Qr=-90,eo=1,po=class extends Nn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new $n(Qr,eo,e,t);s.layers=this.layers,this.add(s);let r=new $n(Qr,eo,e,t);r.layers=this.layers,this.add(r);let o=new $n(Qr,eo,e,t);o.layers=this.layers,this.add(o);let a=new $n(Qr,eo,e,t);a.layers=this.layers,this.add(a);let l=new $n(Qr,eo,e,t);l.layers=this.layers,this.add(l);let c=new $n(Qr,eo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===xi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===io)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let S=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let d=!1;e.isWebGLRenderer===!0?d=e.state.buffers.depth.getReversed():d=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=S,e.setRenderTarget(i,5,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,f,p),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},uc=class extends $n{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Jh="\\[\\]\\.:\\/",Nv=new RegExp("["+Jh+"]","g"),Kh="[^"+Jh+"]",Dv="[^"+Jh.replace("\\.","")+"]",Uv=/((?:WC+[\/:])*)/.source.replace("WC",Kh),Fv=/(WCOD+)?/.source.replace("WCOD",Dv),Ov=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Kh),Bv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Kh),kv=new RegExp("^"+Uv+Fv+Ov+Bv+"$"),zv=["material","materials","bones","map"],yh=class{constructor(e,t,i){let s=i||Ht.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Ht=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Nv,"")}static parseTrackName(e){let t=kv.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);zv.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){$e("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){Ke("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Ke("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Ke("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Ke("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Ke("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){Ke("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){Ke("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Ke("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Ke("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Ke("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ht.Composite=yh;Ht.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ht.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ht.prototype.GetterByBindingType=[Ht.prototype._getValue_direct,Ht.prototype._getValue_array,Ht.prototype._getValue_arrayElement,Ht.prototype._getValue_toArray];Ht.prototype.SetterByBindingTypeAndVersioning=[[Ht.prototype._setValue_direct,Ht.prototype._setValue_direct_setNeedsUpdate,Ht.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ht.prototype._setValue_array,Ht.prototype._setValue_array_setNeedsUpdate,Ht.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ht.prototype._setValue_arrayElement,Ht.prototype._setValue_arrayElement_setNeedsUpdate,Ht.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ht.prototype._setValue_fromArray,Ht.prototype._setValue_fromArray_setNeedsUpdate,Ht.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var aE=new Float32Array(1);var Sp=new vt,ya=class{constructor(e,t,i=0,s=1/0){this.ray=new lo(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new oo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):Ke("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Sp.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Sp),this}intersectObject(e,t=!0,i=[]){return Sh(e,this,i,t),i.sort(Mp),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)Sh(e[s],this,i,t);return i.sort(Mp),i}};function Mp(n,e){return n.distance-e.distance}function Sh(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Sh(r[o],e,t,!0)}}var Mh=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};function jh(n,e,t,i){let s=Vv(i);switch(t){case Vh:return n*e;case vo:return n*e/s.components*s.byteLength;case _c:return n*e/s.components*s.byteLength;case qs:return n*e*2/s.components*s.byteLength;case xc:return n*e*2/s.components*s.byteLength;case Gh:return n*e*3/s.components*s.byteLength;case ei:return n*e*4/s.components*s.byteLength;case vc:return n*e*4/s.components*s.byteLength;case ba:case wa:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Ta:case Aa:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Sc:case bc:return Math.max(n,16)*Math.max(e,8)/4;case yc:case Mc:return Math.max(n,8)*Math.max(e,8)/2;case wc:case Tc:case Ec:case Cc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Ac:case Ea:case Rc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Pc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ic:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Lc:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Nc:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Dc:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Uc:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Fc:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Oc:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Bc:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case kc:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case zc:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Vc:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Gc:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Hc:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Wc:case Xc:case qc:return Math.ceil(n/4)*Math.ceil(e/4)*16;case $c:case Yc:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Ca:case Zc:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Vv(n){switch(n){case kn:case Oh:return{byteLength:1,components:1};case xo:case Bh:case Di:return{byteLength:2,components:1};case mc:case gc:return{byteLength:2,components:4};case Ni:case pc:case yi:return{byteLength:4,components:1};case kh:case zh:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?$e("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Lm(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function Hv(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((p,g)=>p.start-g.start);let f=0;for(let p=1;p<h.length;p++){let g=h[f],S=h[p];S.start<=g.start+g.count+1?g.count=Math.max(g.count,S.start+S.count-g.start):(++f,h[f]=S)}h.length=f+1;for(let p=0,g=h.length;p<g;p++){let S=h[p];n.bufferSubData(c,S.start*u.BYTES_PER_ELEMENT,u,S.start,S.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Wv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Xv=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,qv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,$v=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Yv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Zv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Jv=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Kv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,jv=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Qv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,ey=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,ty=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,ny=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,iy=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,sy=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,ry=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,oy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,ay=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ly=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,cy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,uy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,hy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,fy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,dy=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,py=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,my=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,gy=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,_y=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,xy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,vy="gl_FragColor = linearToOutputTexel( gl_FragColor );",yy=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Sy=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,My=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,by=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,wy=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Ty=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Ay=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Ey=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Cy=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Ry=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Py=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Iy=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Ly=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Ny=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Dy=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Uy=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Fy=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Oy=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,By=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,ky=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,zy=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Vy=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Gy=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Hy=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Wy=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Xy=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,qy=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,$y=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Yy=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Zy=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Jy=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Ky=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,jy=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Qy=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,eS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,tS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,nS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,iS=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,sS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,rS=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,oS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,aS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,lS=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,cS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,uS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,hS=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,fS=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,dS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,pS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,mS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,gS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,_S=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,xS=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,vS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,yS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,SS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,MS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,bS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,wS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,TS=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,AS=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,ES=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,CS=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,RS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,PS=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,IS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,LS=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,NS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,DS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,US=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,FS=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,OS=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,BS=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,kS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,zS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,VS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,GS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,HS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,WS=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,XS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,qS=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,$S=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,YS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ZS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,JS=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,KS=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,jS=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,QS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,eM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,tM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,nM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,iM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,sM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,rM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,oM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,aM=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,lM=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,cM=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,uM=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,hM=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,fM=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,dM=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,pM=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mM=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,gM=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,_M=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,xM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,vM=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,yM=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,SM=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,MM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,lt={alphahash_fragment:Wv,alphahash_pars_fragment:Xv,alphamap_fragment:qv,alphamap_pars_fragment:$v,alphatest_fragment:Yv,alphatest_pars_fragment:Zv,aomap_fragment:Jv,aomap_pars_fragment:Kv,batching_pars_vertex:jv,batching_vertex:Qv,begin_vertex:ey,beginnormal_vertex:ty,bsdfs:ny,iridescence_fragment:iy,bumpmap_pars_fragment:sy,clipping_planes_fragment:ry,clipping_planes_pars_fragment:oy,clipping_planes_pars_vertex:ay,clipping_planes_vertex:ly,color_fragment:cy,color_pars_fragment:uy,color_pars_vertex:hy,color_vertex:fy,common:dy,defaultnormal_vertex:py,displacementmap_pars_vertex:my,displacementmap_vertex:gy,emissivemap_fragment:_y,emissivemap_pars_fragment:xy,colorspace_fragment:vy,colorspace_pars_fragment:yy,envmap_fragment:Sy,envmap_common_pars_fragment:My,envmap_pars_fragment:by,envmap_pars_vertex:wy,envmap_physical_pars_fragment:Uy,envmap_vertex:Ty,fog_vertex:Ay,fog_pars_vertex:Ey,fog_fragment:Cy,fog_pars_fragment:Ry,gradientmap_pars_fragment:Py,lightmap_pars_fragment:Iy,lights_lambert_fragment:Ly,lights_lambert_pars_fragment:Ny,lights_pars_begin:Dy,lights_toon_fragment:Fy,lights_toon_pars_fragment:Oy,lights_phong_fragment:By,lights_phong_pars_fragment:ky,lights_physical_fragment:zy,lights_physical_pars_fragment:Vy,lights_fragment_begin:Gy,lights_fragment_maps:Hy,lights_fragment_end:Wy,lightprobes_pars_fragment:Xy,logdepthbuf_fragment:qy,logdepthbuf_pars_fragment:$y,logdepthbuf_pars_vertex:Yy,logdepthbuf_vertex:Zy,map_fragment:Jy,map_pars_fragment:Ky,map_particle_fragment:jy,map_particle_pars_fragment:Qy,metalnessmap_fragment:eS,metalnessmap_pars_fragment:tS,morphinstance_vertex:nS,morphcolor_vertex:iS,morphnormal_vertex:sS,morphtarget_pars_vertex:rS,morphtarget_vertex:oS,normal_fragment_begin:aS,normal_fragment_maps:lS,normal_pars_fragment:cS,normal_pars_vertex:uS,normal_vertex:hS,normalmap_pars_fragment:fS,clearcoat_normal_fragment_begin:dS,clearcoat_normal_fragment_maps:pS,clearcoat_pars_fragment:mS,iridescence_pars_fragment:gS,opaque_fragment:_S,packing:xS,premultiplied_alpha_fragment:vS,project_vertex:yS,dithering_fragment:SS,dithering_pars_fragment:MS,roughnessmap_fragment:bS,roughnessmap_pars_fragment:wS,shadowmap_pars_fragment:TS,shadowmap_pars_vertex:AS,shadowmap_vertex:ES,shadowmask_pars_fragment:CS,skinbase_vertex:RS,skinning_pars_vertex:PS,skinning_vertex:IS,skinnormal_vertex:LS,specularmap_fragment:NS,specularmap_pars_fragment:DS,tonemapping_fragment:US,tonemapping_pars_fragment:FS,transmission_fragment:OS,transmission_pars_fragment:BS,uv_pars_fragment:kS,uv_pars_vertex:zS,uv_vertex:VS,worldpos_vertex:GS,background_vert:HS,background_frag:WS,backgroundCube_vert:XS,backgroundCube_frag:qS,cube_vert:$S,cube_frag:YS,depth_vert:ZS,depth_frag:JS,distance_vert:KS,distance_frag:jS,equirect_vert:QS,equirect_frag:eM,linedashed_vert:tM,linedashed_frag:nM,meshbasic_vert:iM,meshbasic_frag:sM,meshlambert_vert:rM,meshlambert_frag:oM,meshmatcap_vert:aM,meshmatcap_frag:lM,meshnormal_vert:cM,meshnormal_frag:uM,meshphong_vert:hM,meshphong_frag:fM,meshphysical_vert:dM,meshphysical_frag:pM,meshtoon_vert:mM,meshtoon_frag:gM,points_vert:_M,points_frag:xM,shadow_vert:vM,shadow_frag:yM,sprite_vert:SM,sprite_frag:MM},Le={common:{diffuse:{value:new je(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new et}},envmap:{envMap:{value:null},envMapRotation:{value:new et},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new et}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new et}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new et},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new et},normalScale:{value:new ft(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new et},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new et}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new et}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new et}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new je(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new je(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0},uvTransform:{value:new et}},sprite:{diffuse:{value:new je(16777215)},opacity:{value:1},center:{value:new ft(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}}},es={basic:{uniforms:zn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:lt.meshbasic_vert,fragmentShader:lt.meshbasic_frag},lambert:{uniforms:zn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new je(0)},envMapIntensity:{value:1}}]),vertexShader:lt.meshlambert_vert,fragmentShader:lt.meshlambert_frag},phong:{uniforms:zn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new je(0)},specular:{value:new je(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:lt.meshphong_vert,fragmentShader:lt.meshphong_frag},standard:{uniforms:zn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new je(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:lt.meshphysical_vert,fragmentShader:lt.meshphysical_frag},toon:{uniforms:zn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new je(0)}}]),vertexShader:lt.meshtoon_vert,fragmentShader:lt.meshtoon_frag},matcap:{uniforms:zn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:lt.meshmatcap_vert,fragmentShader:lt.meshmatcap_frag},points:{uniforms:zn([Le.points,Le.fog]),vertexShader:lt.points_vert,fragmentShader:lt.points_frag},dashed:{uniforms:zn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:lt.linedashed_vert,fragmentShader:lt.linedashed_frag},depth:{uniforms:zn([Le.common,Le.displacementmap]),vertexShader:lt.depth_vert,fragmentShader:lt.depth_frag},normal:{uniforms:zn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:lt.meshnormal_vert,fragmentShader:lt.meshnormal_frag},sprite:{uniforms:zn([Le.sprite,Le.fog]),vertexShader:lt.sprite_vert,fragmentShader:lt.sprite_frag},background:{uniforms:{uvTransform:{value:new et},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:lt.background_vert,fragmentShader:lt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new et}},vertexShader:lt.backgroundCube_vert,fragmentShader:lt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:lt.cube_vert,fragmentShader:lt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:lt.equirect_vert,fragmentShader:lt.equirect_frag},distance:{uniforms:zn([Le.common,Le.displacementmap,{referencePosition:{value:new W},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:lt.distance_vert,fragmentShader:lt.distance_frag},shadow:{uniforms:zn([Le.lights,Le.fog,{color:{value:new je(0)},opacity:{value:1}}]),vertexShader:lt.shadow_vert,fragmentShader:lt.shadow_frag}};es.physical={uniforms:zn([es.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new et},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new et},clearcoatNormalScale:{value:new ft(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new et},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new et},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new et},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new et},sheen:{value:0},sheenColor:{value:new je(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new et},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new et},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new et},transmissionSamplerSize:{value:new ft},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new et},attenuationDistance:{value:0},attenuationColor:{value:new je(0)},specularColor:{value:new je(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new et},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new et},anisotropyVector:{value:new ft},anisotropyMap:{value:null},anisotropyMapTransform:{value:new et}}]),vertexShader:lt.meshphysical_vert,fragmentShader:lt.meshphysical_frag};var Kc={r:0,b:0,g:0},bM=new vt,Nm=new et;Nm.set(-1,0,0,0,1,0,0,0,1);function wM(n,e,t,i,s,r){let o=new je(0),a=s===!0?0:1,l,c,u=null,h=0,f=null;function p(y){let C=y.isScene===!0?y.background:null;if(C&&C.isTexture){let b=y.backgroundBlurriness>0;C=e.get(C,b)}return C}function g(y){let C=!1,b=p(y);b===null?d(o,a):b&&b.isColor&&(d(b,1),C=!0);let P=n.xr.getEnvironmentBlendMode();P==="additive"?t.buffers.color.setClear(0,0,0,1,r):P==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||C)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function S(y,C){let b=p(C);b&&b.isCubeTexture?(c===void 0&&(c=new Wt(new uo(1,1,1),new vi({name:"BackgroundCubeMaterial",uniforms:pr(es.backgroundCube.uniforms),vertexShader:es.backgroundCube.vertexShader,fragmentShader:es.backgroundCube.fragmentShader,side:Zn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(P,A,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(bM.makeRotationFromEuler(C.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Nm),c.material.toneMapped=mt.getTransfer(b.colorSpace)!==wt,(u!==b||h!==b.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,h=b.version,f=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Wt(new ar(2,2),new vi({name:"BackgroundMaterial",uniforms:pr(es.background.uniforms),vertexShader:es.background.vertexShader,fragmentShader:es.background.fragmentShader,side:Xs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=mt.getTransfer(b.colorSpace)!==wt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||h!==b.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,h=b.version,f=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function d(y,C){y.getRGB(Kc,Zh(n)),t.buffers.color.setClear(Kc.r,Kc.g,Kc.b,C,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,C=1){o.set(y),a=C,d(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,d(o,a)},render:g,addToRenderList:S,dispose:m}}function TM(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(I,k,V,N,H){let $=!1,G=h(I,N,V,k);r!==G&&(r=G,c(r.object)),$=p(I,N,V,H),$&&g(I,N,V,H),H!==null&&e.update(H,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,b(I,k,V,N),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function h(I,k,V,N){let H=N.wireframe===!0,$=i[k.id];$===void 0&&($={},i[k.id]=$);let G=I.isInstancedMesh===!0?I.id:0,le=$[G];le===void 0&&(le={},$[G]=le);let J=le[V.id];J===void 0&&(J={},le[V.id]=J);let j=J[H];return j===void 0&&(j=f(l()),J[H]=j),j}function f(I){let k=[],V=[],N=[];for(let H=0;H<t;H++)k[H]=0,V[H]=0,N[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:V,attributeDivisors:N,object:I,attributes:{},index:null}}function p(I,k,V,N){let H=r.attributes,$=k.attributes,G=0,le=V.getAttributes();for(let J in le)if(le[J].location>=0){let ie=H[J],he=$[J];if(he===void 0&&(J==="instanceMatrix"&&I.instanceMatrix&&(he=I.instanceMatrix),J==="instanceColor"&&I.instanceColor&&(he=I.instanceColor)),ie===void 0||ie.attribute!==he||he&&ie.data!==he.data)return!0;G++}return r.attributesNum!==G||r.index!==N}function g(I,k,V,N){let H={},$=k.attributes,G=0,le=V.getAttributes();for(let J in le)if(le[J].location>=0){let ie=$[J];ie===void 0&&(J==="instanceMatrix"&&I.instanceMatrix&&(ie=I.instanceMatrix),J==="instanceColor"&&I.instanceColor&&(ie=I.instanceColor));let he={};he.attribute=ie,ie&&ie.data&&(he.data=ie.data),H[J]=he,G++}r.attributes=H,r.attributesNum=G,r.index=N}function S(){let I=r.newAttributes;for(let k=0,V=I.length;k<V;k++)I[k]=0}function d(I){m(I,0)}function m(I,k){let V=r.newAttributes,N=r.enabledAttributes,H=r.attributeDivisors;V[I]=1,N[I]===0&&(n.enableVertexAttribArray(I),N[I]=1),H[I]!==k&&(n.vertexAttribDivisor(I,k),H[I]=k)}function y(){let I=r.newAttributes,k=r.enabledAttributes;for(let V=0,N=k.length;V<N;V++)k[V]!==I[V]&&(n.disableVertexAttribArray(V),k[V]=0)}function C(I,k,V,N,H,$,G){G===!0?n.vertexAttribIPointer(I,k,V,H,$):n.vertexAttribPointer(I,k,V,N,H,$)}function b(I,k,V,N){S();let H=N.attributes,$=V.getAttributes(),G=k.defaultAttributeValues;for(let le in $){let J=$[le];if(J.location>=0){let j=H[le];if(j===void 0&&(le==="instanceMatrix"&&I.instanceMatrix&&(j=I.instanceMatrix),le==="instanceColor"&&I.instanceColor&&(j=I.instanceColor)),j!==void 0){let ie=j.normalized,he=j.itemSize,ue=e.get(j);if(ue===void 0)continue;let Q=ue.buffer,pe=ue.type,xe=ue.bytesPerElement,Ee=pe===n.INT||pe===n.UNSIGNED_INT||j.gpuType===pc;if(j.isInterleavedBufferAttribute){let Me=j.data,He=Me.isInterleavedBuffer===!0?Me.stride:Me.itemSize,it=j.offset;if(Me.isInstancedInterleavedBuffer||Me.isInstancedBufferAttribute){for(let Ve=0;Ve<J.locationSize;Ve++)m(J.location+Ve,Me.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Me.meshPerAttribute*Me.count)}else for(let Ve=0;Ve<J.locationSize;Ve++)d(J.location+Ve);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let Ve=0;Ve<J.locationSize;Ve++)C(J.location+Ve,he/J.locationSize,pe,ie,He*xe,(it+he/J.locationSize*Ve)*xe,Ee)}else{if(j.isInstancedBufferAttribute){for(let Me=0;Me<J.locationSize;Me++)m(J.location+Me,j.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let Me=0;Me<J.locationSize;Me++)d(J.location+Me);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let Me=0;Me<J.locationSize;Me++)C(J.location+Me,he/J.locationSize,pe,ie,he*xe,he/J.locationSize*Me*xe,Ee)}}else if(G!==void 0){let ie=G[le];if(ie!==void 0)switch(ie.length){case 2:n.vertexAttrib2fv(J.location,ie);break;case 3:n.vertexAttrib3fv(J.location,ie);break;case 4:n.vertexAttrib4fv(J.location,ie);break;default:n.vertexAttrib1fv(J.location,ie)}}}}y()}function P(){B();for(let I in i){let k=i[I];for(let V in k){let N=k[V];for(let H in N){let $=N[H];for(let G in $)u($[G].object),delete $[G];delete N[H]}}delete i[I]}}function A(I){if(i[I.id]===void 0)return;let k=i[I.id];for(let V in k){let N=k[V];for(let H in N){let $=N[H];for(let G in $)u($[G].object),delete $[G];delete N[H]}}delete i[I.id]}function x(I){for(let k in i){let V=i[k];for(let N in V){let H=V[N];if(H[I.id]===void 0)continue;let $=H[I.id];for(let G in $)u($[G].object),delete $[G];delete H[I.id]}}}function T(I){for(let k in i){let V=i[k],N=I.isInstancedMesh===!0?I.id:0,H=V[N];if(H!==void 0){for(let $ in H){let G=H[$];for(let le in G)u(G[le].object),delete G[le];delete H[$]}delete V[N],Object.keys(V).length===0&&delete i[k]}}}function B(){D(),o=!0,r!==s&&(r=s,c(r.object))}function D(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:B,resetDefaultState:D,dispose:P,releaseStatesOfGeometry:A,releaseStatesOfObject:T,releaseStatesOfProgram:x,initAttributes:S,enableAttribute:d,disableUnusedAttributes:y}}function AM(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let f=0;for(let p=0;p<u;p++)f+=c[p];t.update(f,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function EM(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==ei&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let T=x===Di&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==kn&&x!==yi&&!T&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&($e("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&$e("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&$e("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),S=n.getParameter(n.MAX_TEXTURE_SIZE),d=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),C=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),P=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:p,maxVertexTextures:g,maxTextureSize:S,maxCubemapSize:d,maxAttributes:m,maxVertexUniforms:y,maxVaryings:C,maxFragmentUniforms:b,maxSamples:P,samples:A}}function CM(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Ii,a=new et,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let p=h.length!==0||f||i!==0||s;return s=f,i=h.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,p){let g=h.clippingPlanes,S=h.clipIntersection,d=h.clipShadows,m=n.get(h);if(!s||g===null||g.length===0||r&&!d)r?u(null):c();else{let y=r?0:i,C=y*4,b=m.clippingState||null;l.value=b,b=u(g,f,C,p);for(let P=0;P!==C;++P)b[P]=t[P];m.clippingState=b,this.numIntersection=S?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,f,p,g){let S=h!==null?h.length:0,d=null;if(S!==0){if(d=l.value,g!==!0||d===null){let m=p+S*4,y=f.matrixWorldInverse;a.getNormalMatrix(y),(d===null||d.length<m)&&(d=new Float32Array(m));for(let C=0,b=p;C!==S;++C,b+=4)o.copy(h[C]).applyMatrix4(y,a),o.normal.toArray(d,b),d[b+3]=o.constant}l.value=d,l.needsUpdate=!0}return e.numPlanes=S,e.numIntersection=0,d}}var La=class extends li{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new ua(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new uo(5,5,5),r=new vi({name:"CubemapFromEquirect",uniforms:pr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Zn,blending:ur});r.uniforms.tEquirect.value=t;let o=new Wt(s,r),a=t.minFilter;return t.minFilter===vs&&(t.minFilter=Yn),new po(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},hm=256,RM=3,PM=20,Dm=256,Um=16,IM=3,LM=new W,NM=new je,Qc=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new po(1,10,null),this._boxMesh=new Wt(new uo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=LM}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,p=l.autoClearDepth,g=l.autoClearStencil,S=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,S===null&&(e.background=l.getClearColor(NM));let d=new po(i,s,u);return d.position.copy(a),d.update(l,e),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=p,l.autoClearStencil=g,e.background=S,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=pm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=dm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(hm,om(e))}_fromTexture(e,t){e.mapping===fr||e.mapping===_o?this._setSize(e.image.length===0?hm:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=fm(e,!1,!1),i=Math.log2(e)-RM;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=fm(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===fr||e.mapping===_o?(this._cubemapMaterial===null&&(this._cubemapMaterial=pm()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=dm()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=DM(),this._integrationMaterial=UM());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Um);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-IM)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Dm*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=FM());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function fm(n,e,t){return new La(n,{minFilter:vs,generateMipmaps:e,type:Di,colorSpace:ea,depthBuffer:t})}function Na(n,e,t){return new vi({name:n,uniforms:e,vertexShader:lt.cube_vert,fragmentShader:t,side:Zn,blending:ur,depthTest:!1,depthWrite:!1})}function DM(){return Na("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Dm}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function UM(){return Na("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Um}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function FM(){return Na("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${PM}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function dm(){return Na("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function pm(){return Na("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function OM(n){let e=new WeakMap,t=new WeakMap,i=null;function s(f,p=!1){return f==null?null:p?o(f):r(f)}function r(f){if(f&&f.isTexture){let p=f.mapping;if(p===hc||p===fc)if(e.has(f)){let g=e.get(f).texture;return a(g,f.mapping)}else{let g=f.image;if(g&&g.height>0){let S=new La(g.height);return S.fromEquirectangularTexture(n,f),e.set(f,S),f.addEventListener("dispose",c),a(S.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let p=f.mapping,g=p===hc||p===fc,S=p===fr||p===_o;if(g||S){let d=t.get(f),m=d!==void 0?d.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==m)return i===null&&(i=new Qc(n)),d=g?i.fromEquirectangular(f,d):i.fromCubemap(f,d),d.texture.pmremVersion=f.pmremVersion,t.set(f,d),d.texture;if(d!==void 0)return d.texture;{let y=f.image;return g&&y&&y.height>0||S&&y&&l(y)?(i===null&&(i=new Qc(n)),d=g?i.fromEquirectangular(f):i.fromCubemap(f),d.texture.pmremVersion=f.pmremVersion,t.set(f,d),f.addEventListener("dispose",u),d.texture):null}}}return f}function a(f,p){return p===hc?f.mapping=fr:p===fc&&(f.mapping=_o),f}function l(f){let p=0,g=6;for(let S=0;S<g;S++)f[S]!==void 0&&p++;return p===g}function c(f){let p=f.target;p.removeEventListener("dispose",c);let g=e.get(p);g!==void 0&&(e.delete(p),g.dispose())}function u(f){let p=f.target;p.removeEventListener("dispose",u);let g=t.get(p);g!==void 0&&(t.delete(p),g.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function BM(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&jo("WebGLRenderer: "+i+" extension not supported."),s}}}function kM(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let d in g.attributes)e.remove(g.attributes[d]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let S=r.get(g);S&&(e.remove(S),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,S){return s[S.id]!==void 0||(S.addEventListener("dispose",a),s[S.id]=new WeakRef(S),o.register(S,S.id,S),t.memory.geometries++),S}function u(g){let S=g.attributes;for(let d in S)e.update(S[d],n.ARRAY_BUFFER)}function h(g){let S=g.index,d=g.attributes.position,m=0;if(d===void 0)return;let y=S!==null?S.array.length:d.array.length/3-1,C=d.count>=65535?oa:ra,b=new C(Math.ceil(y/3)*6,1),P=b.array;if(S!==null){let x=S.array;m=S.version;for(let T=0,B=0;T<y;T+=3){let D=x[T+0],I=x[T+1],k=x[T+2];P[B++]=D,P[B++]=I,P[B++]=I,P[B++]=k,P[B++]=k,P[B++]=D}}else{m=d.version;for(let x=0,T=0;x<y;x+=3){let B=x+0,D=x+1,I=x+2;P[T++]=B,P[T++]=D,P[T++]=D,P[T++]=I,P[T++]=I,P[T++]=B}}b.version=m;let A=r.get(g);A&&e.remove(A),r.set(g,b)}function f(g){let S=r.get(g);if(S){let d=g.index;d!==null&&S.version<d.version&&h(g)}else h(g);return r.get(g)}function p(){for(let g in s){let S=s[g].deref();S!==void 0&&l(S)}}return{get:c,update:u,getWireframeAttribute:f,dispose:p}}function zM(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,f){n.drawElements(i,f,r,h*o),t.update(f,i,1)}function c(h,f,p){p!==0&&(n.drawElementsInstanced(i,f,r,h*o,p),t.update(f,i,p))}function u(h,f,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,h,0,p);let S=0;for(let d=0;d<p;d++)S+=f[d];t.update(S,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function VM(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:Ke("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function GM(n,e,t){let i=new WeakMap,s=new Ot;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let B=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",B)};f!==void 0&&f.texture.dispose();let p=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,S=a.morphAttributes.color!==void 0,d=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],C=0;p===!0&&(C=1),g===!0&&(C=2),S===!0&&(C=3);let b=a.attributes.position.count*C,P=1;b>e.maxTextureSize&&(P=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let A=new Float32Array(b*P*4*h),x=new ia(A,b,P,h);x.type=yi,x.needsUpdate=!0;let T=C*4;for(let D=0;D<h;D++){let I=d[D],k=m[D],V=y[D],N=b*P*4*D;for(let H=0;H<I.count;H++){let $=H*T;p===!0&&(s.fromBufferAttribute(I,H),A[N+$+0]=s.x,A[N+$+1]=s.y,A[N+$+2]=s.z,A[N+$+3]=0),g===!0&&(s.fromBufferAttribute(k,H),A[N+$+4]=s.x,A[N+$+5]=s.y,A[N+$+6]=s.z,A[N+$+7]=0),S===!0&&(s.fromBufferAttribute(V,H),A[N+$+8]=s.x,A[N+$+9]=s.y,A[N+$+10]=s.z,A[N+$+11]=V.itemSize===4?s.w:1)}}f={count:h,texture:x,size:new ft(b,P)},i.set(a,f),a.addEventListener("dispose",B)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let p=0;for(let S=0;S<c.length;S++)p+=c[S];let g=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function HM(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,f=e.get(c,h);if(r.get(f)!==u&&(e.update(f),r.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==u&&(p.update(),r.set(p,u))}return f}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var WM={[Ph]:"LINEAR_TONE_MAPPING",[Ih]:"REINHARD_TONE_MAPPING",[Lh]:"CINEON_TONE_MAPPING",[Nh]:"ACES_FILMIC_TONE_MAPPING",[Uh]:"AGX_TONE_MAPPING",[Sa]:"NEUTRAL_TONE_MAPPING",[Dh]:"CUSTOM_TONE_MAPPING"};function XM(n,e,t,i,s,r){let o=new li(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Dn;u.setAttribute("position",new Jt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Jt([0,2,0,0,2,0],2));let h=new Jl({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new Wt(u,h),p=new xa(-1,1,1,-1,0,1),g=null,S=null,d=!1,m,y=null,C=[],b=!1;this.setSize=function(P,A){o.setSize(P,A),a!==null&&a.setSize(P,A),l!==null&&l.setSize(P,A);for(let x=0;x<C.length;x++){let T=C[x];T.setSize&&T.setSize(P,A)}},this.setEffects=function(P){C=P,b=C.length>0&&C[0].isRenderPass===!0;let A=o.width,x=o.height;C.length>0&&a===null&&(a=new li(A,x,{type:Di,depthBuffer:!1,stencilBuffer:!1}),l=new li(A,x,{type:Di,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&C.some(B=>B.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new _s(A,x),r===!0&&(c.format=ys,c.type=dr)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let B=0;B<C.length;B++){let D=C[B];D.setSize&&D.setSize(A,x),T&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(c)}},this.begin=function(P,A){if(d||P.toneMapping===ji&&C.length===0)return!1;if(y=A,A!==null){let x=A.width,T=A.height;(o.width!==x||o.height!==T)&&this.setSize(x,T)}return b===!1&&P.setRenderTarget(o),m=P.toneMapping,P.toneMapping=ji,!0},this.hasRenderPass=function(){return b},this.end=function(P,A){P.toneMapping=m,d=!0;let x=o,T=a;for(let B=0;B<C.length;B++){let D=C[B];D.enabled!==!1&&(D.render(P,T,x,A),D.needsSwap!==!1&&(x=T,T=T===a?l:a))}if(g!==P.outputColorSpace||S!==P.toneMapping){g=P.outputColorSpace,S=P.toneMapping,h.defines={},mt.getTransfer(g)===wt&&(h.defines.SRGB_TRANSFER="");let B=WM[S];B&&(h.defines[B]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=x.texture,P.setRenderTarget(y),P.render(f,p),y=null,d=!1},this.isCompositing=function(){return d},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Fm=new Qn,Om=new _s(1,1),Bm=new ha(1),km=new ia,zm=new Xl,Vm=new ua,mm=[],gm=[],_m=new Float32Array(16),xm=new Float32Array(9),vm=new Float32Array(4);function So(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=mm[s];if(r===void 0&&(r=new Float32Array(s),mm[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function vn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function yn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function tu(n,e){let t=gm[e];t===void 0&&(t=new Int32Array(e),gm[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function qM(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function $M(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(vn(t,e))return;n.uniform2fv(this.addr,e),yn(t,e)}}function YM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(vn(t,e))return;n.uniform3fv(this.addr,e),yn(t,e)}}function ZM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(vn(t,e))return;n.uniform4fv(this.addr,e),yn(t,e)}}function JM(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(vn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),yn(t,e)}else{if(vn(t,i))return;vm.set(i),n.uniformMatrix2fv(this.addr,!1,vm),yn(t,i)}}function KM(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(vn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),yn(t,e)}else{if(vn(t,i))return;xm.set(i),n.uniformMatrix3fv(this.addr,!1,xm),yn(t,i)}}function jM(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(vn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),yn(t,e)}else{if(vn(t,i))return;_m.set(i),n.uniformMatrix4fv(this.addr,!1,_m),yn(t,i)}}function QM(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function eb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(vn(t,e))return;n.uniform2iv(this.addr,e),yn(t,e)}}function tb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(vn(t,e))return;n.uniform3iv(this.addr,e),yn(t,e)}}function nb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(vn(t,e))return;n.uniform4iv(this.addr,e),yn(t,e)}}function ib(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function sb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(vn(t,e))return;n.uniform2uiv(this.addr,e),yn(t,e)}}function rb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(vn(t,e))return;n.uniform3uiv(this.addr,e),yn(t,e)}}function ob(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(vn(t,e))return;n.uniform4uiv(this.addr,e),yn(t,e)}}function nu(n){return n.version===0&&(n.compareFunction=Xh,n.needsUpdate=!0),n}function ab(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=nu(Om):r=Fm,t.setTexture2D(e||r,s)}function lb(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||zm,s)}function cb(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=nu(Bm):r=Vm,t.setTextureCube(e||r,s)}function ub(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||km,s)}function hb(n){switch(n){case 5126:return qM;case 35664:return $M;case 35665:return YM;case 35666:return ZM;case 35674:return JM;case 35675:return KM;case 35676:return jM;case 5124:case 35670:return QM;case 35667:case 35671:return eb;case 35668:case 35672:return tb;case 35669:case 35673:return nb;case 5125:return ib;case 36294:return sb;case 36295:return rb;case 36296:return ob;case 35678:case 36198:case 36298:case 36306:case 35682:return ab;case 35679:case 36299:case 36307:return lb;case 35680:case 36300:case 36308:case 36293:return cb;case 36289:case 36303:case 36311:case 36292:return ub}}function fb(n,e){n.uniform1fv(this.addr,e)}function db(n,e){let t=So(e,this.size,2);n.uniform2fv(this.addr,t)}function pb(n,e){let t=So(e,this.size,3);n.uniform3fv(this.addr,t)}function mb(n,e){let t=So(e,this.size,4);n.uniform4fv(this.addr,t)}function gb(n,e){let t=So(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function _b(n,e){let t=So(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function xb(n,e){let t=So(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function vb(n,e){n.uniform1iv(this.addr,e)}function yb(n,e){n.uniform2iv(this.addr,e)}function Sb(n,e){n.uniform3iv(this.addr,e)}function Mb(n,e){n.uniform4iv(this.addr,e)}function bb(n,e){n.uniform1uiv(this.addr,e)}function wb(n,e){n.uniform2uiv(this.addr,e)}function Tb(n,e){n.uniform3uiv(this.addr,e)}function Ab(n,e){n.uniform4uiv(this.addr,e)}function Eb(n,e,t){let i=this.cache,s=e.length,r=tu(t,s);vn(i,r)||(n.uniform1iv(this.addr,r),yn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=nu(Om):o=Fm;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function Cb(n,e,t){let i=this.cache,s=e.length,r=tu(t,s);vn(i,r)||(n.uniform1iv(this.addr,r),yn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||zm,r[o])}function Rb(n,e,t){let i=this.cache,s=e.length,r=tu(t,s);vn(i,r)||(n.uniform1iv(this.addr,r),yn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=nu(Bm):o=Vm;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function Pb(n,e,t){let i=this.cache,s=e.length,r=tu(t,s);vn(i,r)||(n.uniform1iv(this.addr,r),yn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||km,r[o])}function Ib(n){switch(n){case 5126:return fb;case 35664:return db;case 35665:return pb;case 35666:return mb;case 35674:return gb;case 35675:return _b;case 35676:return xb;case 5124:case 35670:return vb;case 35667:case 35671:return yb;case 35668:case 35672:return Sb;case 35669:case 35673:return Mb;case 5125:return bb;case 36294:return wb;case 36295:return Tb;case 36296:return Ab;case 35678:case 36198:case 36298:case 36306:case 35682:return Eb;case 35679:case 36299:case 36307:return Cb;case 35680:case 36300:case 36308:case 36293:return Rb;case 36289:case 36303:case 36311:case 36292:return Pb}}var tf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=hb(t.type)}},nf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Ib(t.type)}},sf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Qh=/(\w+)(\])?(\[|\.)?/g;function ym(n,e){n.seq.push(e),n.map[e.id]=e}function Lb(n,e,t){let i=n.name,s=i.length;for(Qh.lastIndex=0;;){let r=Qh.exec(i),o=Qh.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){ym(t,c===void 0?new tf(a,n,e):new nf(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new sf(a),ym(t,h)),t=h}}}var yo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);Lb(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function Sm(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var Nb=37297,Db=0;function Ub(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Mm=new et;function Fb(n){mt._getMatrix(Mm,mt.workingColorSpace,n);let e=`mat3( ${Mm.elements.map(t=>t.toFixed(4))} )`;switch(mt.getTransfer(n)){case ta:return[e,"LinearTransferOETF"];case wt:return[e,"sRGBTransferOETF"];default:return $e("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function bm(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+Ub(n.getShaderSource(e),a)}else return r}function Ob(n,e){let t=Fb(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Bb={[Ph]:"Linear",[Ih]:"Reinhard",[Lh]:"Cineon",[Nh]:"ACESFilmic",[Uh]:"AgX",[Sa]:"Neutral",[Dh]:"Custom"};function kb(n,e){let t=Bb[e];return t===void 0?($e("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var jc=new W;function zb(){mt.getLuminanceCoefficients(jc);let n=jc.x.toFixed(4),e=jc.y.toFixed(4),t=jc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Vb(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ia).join(`
`)}function Gb(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function Hb(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Ia(n){return n!==""}function wm(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Tm(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var Wb=/^[ \t]*#include +<([\w\d./]+)>/gm;function rf(n){return n.replace(Wb,Xb)}function Xb(n,e){let t=lt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return rf(t)}var qb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Am(n){return n.replace(qb,$b)}function $b(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Em(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var Yb={[cr]:"SHADOWMAP_TYPE_PCF",[mo]:"SHADOWMAP_TYPE_VSM"};function Zb(n){return Yb[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Jb={[_o]:"ENVMAP_MODE_REFRACTION"};function Kb(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":Jb[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var jb={[Rh]:"ENVMAP_BLENDING_MULTIPLY",[Wp]:"ENVMAP_BLENDING_MIX",[Xp]:"ENVMAP_BLENDING_ADD"};function Qb(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":jb[n.combine]||"ENVMAP_BLENDING_NONE"}function ew(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=Zb(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=Kb(t),h=Qb(t),f=Vb(t),p=Gb(r),g=s.createProgram(),S,d,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(S=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(Ia).join(`
`),S.length>0&&(S+=`
`),d=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(Ia).join(`
`),d.length>0&&(d+=`
`)):(S=[Em(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ia).join(`
`),d=[Em(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ji?"#define TONE_MAPPING":"",t.toneMapping!==ji?lt.tonemapping_pars_fragment:"",t.toneMapping!==ji?kb("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",lt.colorspace_pars_fragment,Ob("linearToOutputTexel",t.outputColorSpace),zb(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ia).join(`
`)),o=rf(o),o=wm(o,t),o=Tm(o,t),a=rf(a),a=wm(a,t),a=Tm(a,t),o=Am(o),a=Am(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,S=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+S,d=["#define varying in",t.glslVersion===qh?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===qh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let y=m+S+o,C=m+d+a,b=Sm(s,s.VERTEX_SHADER,y),P=Sm(s,s.FRAGMENT_SHADER,C);s.attachShader(g,b),s.attachShader(g,P),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function A(D){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(g)||"",k=s.getShaderInfoLog(b)||"",V=s.getShaderInfoLog(P)||"",N=I.trim(),H=k.trim(),$=V.trim(),G=!0,le=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,b,P);else{let J=bm(s,b,"vertex"),j=bm(s,P,"fragment");Ke("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+N+`
`+J+`
`+j)}else N!==""?$e("WebGLProgram: Program Info Log:",N):(H===""||$==="")&&(le=!1);le&&(D.diagnostics={runnable:G,programLog:N,vertexShader:{log:H,prefix:S},fragmentShader:{log:$,prefix:d}})}s.deleteShader(b),s.deleteShader(P),x=new yo(s,g),T=Hb(s,g)}let x;this.getUniforms=function(){return x===void 0&&A(this),x};let T;this.getAttributes=function(){return T===void 0&&A(this),T};let B=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=s.getProgramParameter(g,Nb)),B},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Db++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=b,this.fragmentShader=P,this}var tw=0,of=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new af(e),t.set(e,i)),i}},af=class{constructor(e){this.id=tw++,this.code=e,this.usedTimes=0}};function nw(n){return n===qs||n===Ea||n===Ca}function iw(n,e,t,i,s,r){let o=new oo,a=new of,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,T,B,D,I,k){let V=D.fog,N=I.geometry,H=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?D.environment:null,$=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,G=e.get(x.envMap||H,$),le=f[x.type],J=i.precision;x.precision!==null&&(J=i.getMaxPrecision(x.precision),J!==x.precision&&$e("WebGLProgram.getParameters:",x.precision,"not supported, using",J,"instead."));let j=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ie=j!==void 0?j.length:0,he=0;N.morphAttributes.position!==void 0&&(he=1),N.morphAttributes.normal!==void 0&&(he=2),N.morphAttributes.color!==void 0&&(he=3);let ue,Q,pe,xe;if(le){let Ce=es[le];ue=Ce.vertexShader,Q=Ce.fragmentShader}else{ue=x.vertexShader,Q=x.fragmentShader;let Ce=a.getVertexShaderStage(x),rt=a.getFragmentShaderStage(x);a.update(x,Ce,rt),pe=Ce.id,xe=rt.id}let Ee=n.getRenderTarget(),Me=n.state.buffers.depth.getReversed(),He=I.isInstancedMesh===!0,it=I.isBatchedMesh===!0,Ve=!!x.map,ct=!!x.matcap,ot=!!G,tt=ot&&G.isPMREMTexture===!0,qt=!!x.aoMap,Ft=!!x.lightMap,an=!!x.bumpMap&&x.wireframe===!1,Pt=!!x.normalMap,wn=!!x.displacementMap,xt=!!x.emissiveMap,gn=!!x.metalnessMap,Kt=!!x.roughnessMap,ln=x.anisotropy>0,F=x.clearcoat>0,Re=x.diffuseRoughness>0,qe=x.dispersion>0,st=x.retroreflectivity>0,be=x.iridescence>0,Nt=x.sheen>0,ze=x.transmission>0,Xe=ln&&!!x.anisotropyMap,E=F&&!!x.clearcoatMap,v=F&&!!x.clearcoatNormalMap,X=F&&!!x.clearcoatRoughnessMap,ce=Re&&!!x.diffuseRoughnessMap,re=be&&!!x.iridescenceMap,ge=be&&!!x.iridescenceThicknessMap,ve=Nt&&!!x.sheenColorMap,ee=Nt&&!!x.sheenRoughnessMap,ne=!!x.specularMap,de=!!x.specularColorMap,U=!!x.specularIntensityMap,se=ze&&!!x.transmissionMap,te=ze&&!!x.thicknessMap,we=!!x.gradientMap,me=!!x.alphaMap,Se=x.alphaTest>0,Ge=!!x.alphaHash,Ze=!!x.extensions,ae=ji;x.toneMapped&&(Ee===null||Ee.isXRRenderTarget===!0)&&(ae=n.toneMapping);let Oe=tt?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Je={shaderID:le,shaderType:x.type,shaderName:x.name,vertexShader:ue,fragmentShader:Q,defines:x.defines,customVertexShaderID:pe,customFragmentShaderID:xe,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:J,batching:it,batchingColor:it&&I._colorsTexture!==null,instancing:He,instancingColor:He&&I.instanceColor!==null,instancingMorph:He&&I.morphTexture!==null,outputColorSpace:Ee===null?n.outputColorSpace:Ee.isXRRenderTarget===!0?Ee.texture.colorSpace:mt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Ve,matcap:ct,envMap:ot,envMapMode:ot&&G.mapping,envMapPMREM:tt,envMapMaxLod:tt?Oe.length-1:null,envMapSize:tt?Oe[0].width:null,aoMap:qt,lightMap:Ft,bumpMap:an,normalMap:Pt,displacementMap:wn,emissiveMap:xt,normalMapObjectSpace:Pt&&x.normalMapType===Yp,normalMapTangentSpace:Pt&&x.normalMapType===Jc,packedNormalMap:Pt&&x.normalMapType===Jc&&nw(x.normalMap.format),metalnessMap:gn,roughnessMap:Kt,anisotropy:ln,anisotropyMap:Xe,clearcoat:F,clearcoatMap:E,clearcoatNormalMap:v,clearcoatRoughnessMap:X,diffuseRoughness:Re,diffuseRoughnessMap:ce,dispersion:qe,retroreflection:st,iridescence:be,iridescenceMap:re,iridescenceThicknessMap:ge,sheen:Nt,sheenColorMap:ve,sheenRoughnessMap:ee,specularMap:ne,specularColorMap:de,specularIntensityMap:U,transmission:ze,transmissionMap:se,thicknessMap:te,gradientMap:we,opaque:x.transparent===!1&&x.blending===go&&x.alphaToCoverage===!1,alphaMap:me,alphaTest:Se,alphaHash:Ge,combine:x.combine,mapUv:Ve&&p(x.map.channel),aoMapUv:qt&&p(x.aoMap.channel),lightMapUv:Ft&&p(x.lightMap.channel),bumpMapUv:an&&p(x.bumpMap.channel),normalMapUv:Pt&&p(x.normalMap.channel),displacementMapUv:wn&&p(x.displacementMap.channel),emissiveMapUv:xt&&p(x.emissiveMap.channel),metalnessMapUv:gn&&p(x.metalnessMap.channel),roughnessMapUv:Kt&&p(x.roughnessMap.channel),anisotropyMapUv:Xe&&p(x.anisotropyMap.channel),clearcoatMapUv:E&&p(x.clearcoatMap.channel),clearcoatNormalMapUv:v&&p(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&p(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ce&&p(x.diffuseRoughnessMap.channel),iridescenceMapUv:re&&p(x.iridescenceMap.channel),iridescenceThicknessMapUv:ge&&p(x.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&p(x.sheenColorMap.channel),sheenRoughnessMapUv:ee&&p(x.sheenRoughnessMap.channel),specularMapUv:ne&&p(x.specularMap.channel),specularColorMapUv:de&&p(x.specularColorMap.channel),specularIntensityMapUv:U&&p(x.specularIntensityMap.channel),transmissionMapUv:se&&p(x.transmissionMap.channel),thicknessMapUv:te&&p(x.thicknessMap.channel),alphaMapUv:me&&p(x.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Pt||ln),vertexNormals:!!N.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!N.attributes.uv&&(Ve||me),fog:!!V,useFog:x.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||N.attributes.normal===void 0&&Pt===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Me,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:he,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:k.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&B.length>0,shadowMapType:n.shadowMap.type,toneMapping:ae,decodeVideoTexture:Ve&&x.map.isVideoTexture===!0&&mt.getTransfer(x.map.colorSpace)===wt,decodeVideoTextureEmissive:xt&&x.emissiveMap.isVideoTexture===!0&&mt.getTransfer(x.emissiveMap.colorSpace)===wt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Ki,flipSided:x.side===Zn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Ze&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ze&&x.extensions.multiDraw===!0||it)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Je.vertexUv1s=l.has(1),Je.vertexUv2s=l.has(2),Je.vertexUv3s=l.has(3),l.clear(),Je}function S(x){let T=[];if(x.shaderID?T.push(x.shaderID):(T.push(x.customVertexShaderID),T.push(x.customFragmentShaderID)),x.defines!==void 0)for(let B in x.defines)T.push(B),T.push(x.defines[B]);return x.isRawShaderMaterial===!1&&(d(T,x),m(T,x),T.push(n.outputColorSpace)),T.push(x.customProgramCacheKey),T.join()}function d(x,T){x.push(T.precision),x.push(T.outputColorSpace),x.push(T.envMapMode),x.push(T.envMapPMREM),x.push(T.envMapMaxLod),x.push(T.envMapSize),x.push(T.mapUv),x.push(T.alphaMapUv),x.push(T.lightMapUv),x.push(T.aoMapUv),x.push(T.bumpMapUv),x.push(T.normalMapUv),x.push(T.displacementMapUv),x.push(T.emissiveMapUv),x.push(T.metalnessMapUv),x.push(T.roughnessMapUv),x.push(T.anisotropyMapUv),x.push(T.clearcoatMapUv),x.push(T.clearcoatNormalMapUv),x.push(T.clearcoatRoughnessMapUv),x.push(T.diffuseRoughnessMapUv),x.push(T.iridescenceMapUv),x.push(T.iridescenceThicknessMapUv),x.push(T.sheenColorMapUv),x.push(T.sheenRoughnessMapUv),x.push(T.specularMapUv),x.push(T.specularColorMapUv),x.push(T.specularIntensityMapUv),x.push(T.transmissionMapUv),x.push(T.thicknessMapUv),x.push(T.combine),x.push(T.fogExp2),x.push(T.sizeAttenuation),x.push(T.morphTargetsCount),x.push(T.numSunLights),x.push(T.numDirLights),x.push(T.numPointLights),x.push(T.numSpotLights),x.push(T.numSpotLightMaps),x.push(T.numHemiLights),x.push(T.numRectAreaLights),x.push(T.numSunLightShadows),x.push(T.numDirLightShadows),x.push(T.numPointLightShadows),x.push(T.numSpotLightShadows),x.push(T.numSpotLightShadowsWithMaps),x.push(T.numLightProbes),x.push(T.numLightProbeGrids),x.push(T.shadowMapType),x.push(T.toneMapping),x.push(T.numClippingPlanes),x.push(T.numClipIntersection),x.push(T.depthPacking)}function m(x,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function y(x){let T=f[x.type],B;if(T){let D=es[T];B=lm.clone(D.uniforms)}else B=x.uniforms;return B}function C(x,T){let B=u.get(T);return B!==void 0?++B.usedTimes:(B=new ew(n,T,x,s),c.push(B),u.set(T,B)),B}function b(x){if(--x.usedTimes===0){let T=c.indexOf(x);c[T]=c[c.length-1],c.pop(),u.delete(x.cacheKey),x.destroy()}}function P(x){a.remove(x)}function A(){a.dispose()}return{getParameters:g,getProgramCacheKey:S,getUniforms:y,acquireProgram:C,releaseProgram:b,releaseShaderCache:P,programs:c,dispose:A}}function sw(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function rw(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Cm(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Rm(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(f){let p=0;return f.isInstancedMesh&&(p+=2),f.isSkinnedMesh&&(p+=1),p}function a(f,p,g,S,d,m){let y=n[e];return y===void 0?(y={id:f.id,object:f,geometry:p,material:g,materialVariant:o(f),groupOrder:S,renderOrder:f.renderOrder,z:d,group:m},n[e]=y):(y.id=f.id,y.object=f,y.geometry=p,y.material=g,y.materialVariant=o(f),y.groupOrder=S,y.renderOrder=f.renderOrder,y.z=d,y.group=m),e++,y}function l(f,p,g,S,d,m,y){y.reversedDepth===!0&&(d=-d);let C=a(f,p,g,S,d,m);g.transmission>0?i.push(C):g.transparent===!0?s.push(C):t.push(C)}function c(f,p,g,S,d,m){let y=a(f,p,g,S,d,m);g.transmission>0?i.unshift(y):g.transparent===!0?s.unshift(y):t.unshift(y)}function u(f,p){t.length>1&&t.sort(f||rw),i.length>1&&i.sort(p||Cm),s.length>1&&s.sort(p||Cm)}function h(){for(let f=e,p=n.length;f<p;f++){let g=n[f];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function ow(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Rm,n.set(i,[o])):s>=r.length?(o=new Rm,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function aw(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new W,color:new je};break;case"SpotLight":t={position:new W,direction:new W,color:new je,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new W,color:new je,distance:0,decay:0};break;case"HemisphereLight":t={direction:new W,skyColor:new je,groundColor:new je};break;case"RectAreaLight":t={color:new je,position:new W,halfWidth:new W,halfHeight:new W};break}return n[e.id]=t,t}}}function lw(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ft};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ft};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ft,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var cw=0;function uw(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function hw(n){let e=new aw,t=lw(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new W);let s=new W,r=new vt,o=new vt;function a(c){let u=0,h=0,f=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let p=0,g=0,S=0,d=0,m=0,y=0,C=0,b=0,P=0,A=0,x=0,T=0,B=0,D=0;c.sort(uw);for(let k=0,V=c.length;k<V;k++){let N=c[k],H=N.color,$=N.intensity,G=N.distance,le=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===qs?le=N.shadow.map.texture:le=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=H.r*$,h+=H.g*$,f+=H.b*$;else if(N.isLightProbe){for(let J=0;J<9;J++)i.probe[J].addScaledVector(N.sh.coefficients[J],$);D++}else if(N.isSunLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let j=N.shadow,ie=t.get(N);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[g]=ie,i.sunShadowMap[g]=le;let he=j.getViewportCount();for(let ue=0;ue<he;ue++)i.sunShadowMatrix[S+ue]=j.getMatrix(ue),i.sunShadowCascade[S+ue]=j._cascadeData[ue];S+=he,g++}i.sun[p]=J,p++}else if(N.isDirectionalLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let j=N.shadow,ie=t.get(N);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,i.directionalShadow[d]=ie,i.directionalShadowMap[d]=le,i.directionalShadowMatrix[d]=N.shadow.matrix,P++}i.directional[d]=J,d++}else if(N.isSpotLight){let J=e.get(N);J.position.setFromMatrixPosition(N.matrixWorld),J.color.copy(H).multiplyScalar($),J.distance=G,J.coneCos=Math.cos(N.angle),J.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),J.decay=N.decay,i.spot[y]=J;let j=N.shadow;if(N.map&&(i.spotLightMap[T]=N.map,T++,j.updateMatrices(N),N.castShadow&&B++),i.spotLightMatrix[y]=j.matrix,N.castShadow){let ie=t.get(N);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,i.spotShadow[y]=ie,i.spotShadowMap[y]=le,x++}y++}else if(N.isRectAreaLight){let J=e.get(N);J.color.copy(H).multiplyScalar($),J.halfWidth.set(N.width*.5,0,0),J.halfHeight.set(0,N.height*.5,0),i.rectArea[C]=J,C++}else if(N.isPointLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),J.distance=N.distance,J.decay=N.decay,N.castShadow){let j=N.shadow,ie=t.get(N);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,ie.shadowCameraNear=j.camera.near,ie.shadowCameraFar=j.camera.far,i.pointShadow[m]=ie,i.pointShadowMap[m]=le,i.pointShadowMatrix[m]=N.shadow.matrix,A++}i.point[m]=J,m++}else if(N.isHemisphereLight){let J=e.get(N);J.skyColor.copy(N.color).multiplyScalar($),J.groundColor.copy(N.groundColor).multiplyScalar($),i.hemi[b]=J,b++}}C>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let I=i.hash;(I.sunLength!==p||I.directionalLength!==d||I.pointLength!==m||I.spotLength!==y||I.rectAreaLength!==C||I.hemiLength!==b||I.numSunShadows!==g||I.numDirectionalShadows!==P||I.numPointShadows!==A||I.numSpotShadows!==x||I.numSpotMaps!==T||I.numLightProbes!==D)&&(i.sun.length=p,i.directional.length=d,i.spot.length=y,i.rectArea.length=C,i.point.length=m,i.hemi.length=b,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=S,i.sunShadowCascade.length=S,i.directionalShadow.length=P,i.directionalShadowMap.length=P,i.directionalShadowMatrix.length=P,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+T-B,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=B,i.numLightProbes=D,I.sunLength=p,I.directionalLength=d,I.pointLength=m,I.spotLength=y,I.rectAreaLength=C,I.hemiLength=b,I.numSunShadows=g,I.numDirectionalShadows=P,I.numPointShadows=A,I.numSpotShadows=x,I.numSpotMaps=T,I.numLightProbes=D,i.version=cw++)}function l(c,u){let h=0,f=0,p=0,g=0,S=0,d=0,m=u.matrixWorldInverse;for(let y=0,C=c.length;y<C;y++){let b=c[y];if(b.isSunLight){let P=i.sun[h];P.direction.setFromMatrixPosition(b.matrixWorld),P.direction.transformDirection(m),h++}else if(b.isDirectionalLight){let P=i.directional[f];P.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),f++}else if(b.isSpotLight){let P=i.spot[g];P.position.setFromMatrixPosition(b.matrixWorld),P.position.applyMatrix4(m),P.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),g++}else if(b.isRectAreaLight){let P=i.rectArea[S];P.position.setFromMatrixPosition(b.matrixWorld),P.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),P.halfWidth.set(b.width*.5,0,0),P.halfHeight.set(0,b.height*.5,0),P.halfWidth.applyMatrix4(o),P.halfHeight.applyMatrix4(o),S++}else if(b.isPointLight){let P=i.point[p];P.position.setFromMatrixPosition(b.matrixWorld),P.position.applyMatrix4(m),p++}else if(b.isHemisphereLight){let P=i.hemi[d];P.direction.setFromMatrixPosition(b.matrixWorld),P.direction.transformDirection(m),d++}}}return{setup:a,setupView:l,state:i}}function Pm(n){let e=new hw(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function fw(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Pm(n),e.set(s,[a])):r>=o.length?(a=new Pm(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var dw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,pw=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,mw=[new W(1,0,0),new W(-1,0,0),new W(0,1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1)],gw=[new W(0,-1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1),new W(0,-1,0),new W(0,-1,0)],Im=new vt,Pa=new W,ef=new W;function _w(n,e,t){let i=new zs,s=new ft,r=new ft,o=new Ot,a=new Kl,l=new jl,c={},u=t.maxTextureSize,h={[Xs]:Zn,[Zn]:Xs,[Ki]:Ki},f=new vi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ft},radius:{value:4}},vertexShader:dw,fragmentShader:pw}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let g=new Dn;g.setAttribute("position",new on(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let S=new Wt(g,f),d=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=cr;let m=this.type;this.render=function(A,x,T){if(d.enabled===!1||d.autoUpdate===!1&&d.needsUpdate===!1||A.length===0)return;this.type===Tp&&($e("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=cr);let B=n.getRenderTarget(),D=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),k=n.state;k.setBlending(ur),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let V=m!==this.type;V&&x.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(H=>H.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,H=A.length;N<H;N++){let $=A[N],G=$.shadow;if(G===void 0){$e("WebGLShadowMap:",$,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let le=G.getFrameExtents();s.multiply(le),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,G.mapSize.y=r.y));let J=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=J,G.map===null||V===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===mo){if($.isPointLight){$e("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new li(s.x,s.y,{format:qs,type:Di,minFilter:Yn,magFilter:Yn,generateMipmaps:!1}),G.map.texture.name=$.name+".shadowMap",G.map.depthTexture=new _s(s.x,s.y,yi),G.map.depthTexture.name=$.name+".shadowMapDepth",G.map.depthTexture.format=ps,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Pn,G.map.depthTexture.magFilter=Pn}else $.isPointLight?(G.map=new La(s.x),G.map.depthTexture=new ha(s.x,Ni)):(G.map=new li(s.x,s.y),G.map.depthTexture=new _s(s.x,s.y,Ni)),G.map.depthTexture.name=$.name+".shadowMap",G.map.depthTexture.format=ps,this.type===cr?(G.map.depthTexture.compareFunction=J?Wh:Hh,G.map.depthTexture.minFilter=Yn,G.map.depthTexture.magFilter=Yn):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Pn,G.map.depthTexture.magFilter=Pn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let j=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();$.isPointLight!==!0&&G.updateMatrices($,T);let ie=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:T.layers;for(let he=0;he<j;he++){let ue=G.getCamera(he);if($.isPointLight){let Q=G.camera,pe=G.matrix,xe=$.distance||Q.far;xe!==Q.far&&(Q.far=xe,Q.updateProjectionMatrix()),Pa.setFromMatrixPosition($.matrixWorld),Q.position.copy(Pa),ef.copy(Q.position),ef.add(mw[he]),Q.up.copy(gw[he]),Q.lookAt(ef),Q.updateMatrixWorld(),pe.makeTranslation(-Pa.x,-Pa.y,-Pa.z),Im.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Im,Q.coordinateSystem,Q.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,he),n.clear();else{he===0&&(n.setRenderTarget(G.map),n.clear());let Q=G.getViewport(he);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),k.viewport(o)}i=G.getFrustum(he),b(x,T,ue,$,ie,this.type)}G.isPointLightShadow!==!0&&this.type===mo&&y(G,T),G.needsUpdate=!1}m=this.type,d.needsUpdate=!1,n.setRenderTarget(B,D,I)};function y(A,x){let T=e.update(S);f.defines.VSM_SAMPLES!==A.blurSamples&&(f.defines.VSM_SAMPLES=A.blurSamples,p.defines.VSM_SAMPLES=A.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),A.mapPass===null?A.mapPass=new li(s.x,s.y,{format:qs,type:Di}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),f.uniforms.shadow_pass.value=A.map.depthTexture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(x,null,T,f,S,null),p.uniforms.shadow_pass.value=A.mapPass.texture,p.uniforms.resolution.value.set(A.map.width,A.map.height),p.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(x,null,T,p,S,null)}function C(A,x,T,B){let D=null,I=T.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(I!==void 0)D=I;else if(D=T.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let k=D.uuid,V=x.uuid,N=c[k];N===void 0&&(N={},c[k]=N);let H=N[V];H===void 0&&(H=D.clone(),N[V]=H,x.addEventListener("dispose",P)),D=H}if(D.visible=x.visible,D.wireframe=x.wireframe,B===mo?D.side=x.shadowSide!==null?x.shadowSide:x.side:D.side=x.shadowSide!==null?x.shadowSide:h[x.side],D.alphaMap=x.alphaMap,D.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,D.map=x.map,D.clipShadows=x.clipShadows,D.clippingPlanes=x.clippingPlanes,D.clipIntersection=x.clipIntersection,D.displacementMap=x.displacementMap,D.displacementScale=x.displacementScale,D.displacementBias=x.displacementBias,D.wireframeLinewidth=x.wireframeLinewidth,D.linewidth=x.linewidth,T.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let k=n.properties.get(D);k.light=T}return D}function b(A,x,T,B,D,I){if(A.visible===!1)return;if(A.layers.test(D)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&I===mo)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,A.matrixWorld);let N=e.update(A),H=A.material;if(Array.isArray(H)){let $=N.groups;for(let G=0,le=$.length;G<le;G++){let J=$[G],j=H[J.materialIndex];if(j&&j.visible){let ie=C(A,j,B,I);A.onBeforeShadow(n,A,x,T,N,ie,J),n.renderBufferDirect(T,null,N,ie,A,J),A.onAfterShadow(n,A,x,T,N,ie,J)}}}else if(H.visible){let $=C(A,H,B,I);A.onBeforeShadow(n,A,x,T,N,$,null),n.renderBufferDirect(T,null,N,$,A,null),A.onAfterShadow(n,A,x,T,N,$,null)}}let V=A.children;for(let N=0,H=V.length;N<H;N++)b(V[N],x,T,B,D,I)}function P(A){A.target.removeEventListener("dispose",P);for(let T in c){let B=c[T],D=A.target.uuid;D in B&&(B[D].dispose(),delete B[D])}}}function xw(n,e){function t(){let U=!1,se=new Ot,te=null,we=new Ot(0,0,0,0);return{setMask:function(me){te!==me&&!U&&(n.colorMask(me,me,me,me),te=me)},setLocked:function(me){U=me},setClear:function(me,Se,Ge,Ze,ae){ae===!0&&(me*=Ze,Se*=Ze,Ge*=Ze),se.set(me,Se,Ge,Ze),we.equals(se)===!1&&(n.clearColor(me,Se,Ge,Ze),we.copy(se))},reset:function(){U=!1,te=null,we.set(-1,0,0,0)}}}function i(){let U=!1,se=!1,te=null,we=null,me=null;return{setReversed:function(Se){if(se!==Se){let Ge=e.get("EXT_clip_control");Se?Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.ZERO_TO_ONE_EXT):Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.NEGATIVE_ONE_TO_ONE_EXT),se=Se;let Ze=me;me=null,this.setClear(Ze)}},getReversed:function(){return se},setTest:function(Se){Se?Me(n.DEPTH_TEST):He(n.DEPTH_TEST)},setMask:function(Se){te!==Se&&!U&&(n.depthMask(Se),te=Se)},setFunc:function(Se){if(se&&(Se=rm[Se]),we!==Se){switch(Se){case Ll:n.depthFunc(n.NEVER);break;case Nl:n.depthFunc(n.ALWAYS);break;case Dl:n.depthFunc(n.LESS);break;case no:n.depthFunc(n.LEQUAL);break;case Ul:n.depthFunc(n.EQUAL);break;case Fl:n.depthFunc(n.GEQUAL);break;case Ol:n.depthFunc(n.GREATER);break;case Bl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}we=Se}},setLocked:function(Se){U=Se},setClear:function(Se){me!==Se&&(me=Se,se&&(Se=1-Se),n.clearDepth(Se))},reset:function(){U=!1,te=null,we=null,me=null,se=!1}}}function s(){let U=!1,se=null,te=null,we=null,me=null,Se=null,Ge=null,Ze=null,ae=null;return{setTest:function(Oe){U||(Oe?Me(n.STENCIL_TEST):He(n.STENCIL_TEST))},setMask:function(Oe){se!==Oe&&!U&&(n.stencilMask(Oe),se=Oe)},setFunc:function(Oe,Je,Ce){(te!==Oe||we!==Je||me!==Ce)&&(n.stencilFunc(Oe,Je,Ce),te=Oe,we=Je,me=Ce)},setOp:function(Oe,Je,Ce){(Se!==Oe||Ge!==Je||Ze!==Ce)&&(n.stencilOp(Oe,Je,Ce),Se=Oe,Ge=Je,Ze=Ce)},setLocked:function(Oe){U=Oe},setClear:function(Oe){ae!==Oe&&(n.clearStencil(Oe),ae=Oe)},reset:function(){U=!1,se=null,te=null,we=null,me=null,Se=null,Ge=null,Ze=null,ae=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},f={},p=new WeakMap,g=[],S=null,d=!1,m=null,y=null,C=null,b=null,P=null,A=null,x=null,T=new je(0,0,0),B=0,D=!1,I=null,k=null,V=null,N=null,H=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,le=0,J=n.getParameter(n.VERSION);J.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(J)[1]),G=le>=1):J.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),G=le>=2);let j=null,ie={},he=n.getParameter(n.SCISSOR_BOX),ue=n.getParameter(n.VIEWPORT),Q=new Ot().fromArray(he),pe=new Ot().fromArray(ue);function xe(U,se,te,we){let me=new Uint8Array(4),Se=n.createTexture();n.bindTexture(U,Se),n.texParameteri(U,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(U,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ge=0;Ge<te;Ge++)U===n.TEXTURE_3D||U===n.TEXTURE_2D_ARRAY?n.texImage3D(se,0,n.RGBA,1,1,we,0,n.RGBA,n.UNSIGNED_BYTE,me):n.texImage2D(se+Ge,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,me);return Se}let Ee={};Ee[n.TEXTURE_2D]=xe(n.TEXTURE_2D,n.TEXTURE_2D,1),Ee[n.TEXTURE_CUBE_MAP]=xe(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ee[n.TEXTURE_2D_ARRAY]=xe(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ee[n.TEXTURE_3D]=xe(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Me(n.DEPTH_TEST),o.setFunc(no),an(!1),Pt(bh),Me(n.CULL_FACE),qt(ur);function Me(U){u[U]!==!0&&(n.enable(U),u[U]=!0)}function He(U){u[U]!==!1&&(n.disable(U),u[U]=!1)}function it(U,se){return f[U]!==se?(n.bindFramebuffer(U,se),f[U]=se,U===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=se),U===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=se),!0):!1}function Ve(U,se){let te=g,we=!1;if(U){te=p.get(se),te===void 0&&(te=[],p.set(se,te));let me=U.textures;if(te.length!==me.length||te[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,Ge=me.length;Se<Ge;Se++)te[Se]=n.COLOR_ATTACHMENT0+Se;te.length=me.length,we=!0}}else te[0]!==n.BACK&&(te[0]=n.BACK,we=!0);we&&n.drawBuffers(te)}function ct(U){return S!==U?(n.useProgram(U),S=U,!0):!1}let ot={[hr]:n.FUNC_ADD,[Ep]:n.FUNC_SUBTRACT,[Cp]:n.FUNC_REVERSE_SUBTRACT};ot[Rp]=n.MIN,ot[Pp]=n.MAX;let tt={[Ip]:n.ZERO,[Lp]:n.ONE,[Np]:n.SRC_COLOR,[Eh]:n.SRC_ALPHA,[kp]:n.SRC_ALPHA_SATURATE,[Op]:n.DST_COLOR,[Up]:n.DST_ALPHA,[Dp]:n.ONE_MINUS_SRC_COLOR,[Ch]:n.ONE_MINUS_SRC_ALPHA,[Bp]:n.ONE_MINUS_DST_COLOR,[Fp]:n.ONE_MINUS_DST_ALPHA,[zp]:n.CONSTANT_COLOR,[Vp]:n.ONE_MINUS_CONSTANT_COLOR,[Gp]:n.CONSTANT_ALPHA,[Hp]:n.ONE_MINUS_CONSTANT_ALPHA};function qt(U,se,te,we,me,Se,Ge,Ze,ae,Oe){if(U===ur){d===!0&&(He(n.BLEND),d=!1);return}if(d===!1&&(Me(n.BLEND),d=!0),U!==Ap){if(U!==m||Oe!==D){if((y!==hr||P!==hr)&&(n.blendEquation(n.FUNC_ADD),y=hr,P=hr),Oe)switch(U){case go:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case wh:n.blendFunc(n.ONE,n.ONE);break;case Th:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Ah:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Ke("WebGLState: Invalid blending: ",U);break}else switch(U){case go:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case wh:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Th:Ke("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Ah:Ke("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ke("WebGLState: Invalid blending: ",U);break}C=null,b=null,A=null,x=null,T.set(0,0,0),B=0,m=U,D=Oe}return}me=me||se,Se=Se||te,Ge=Ge||we,(se!==y||me!==P)&&(n.blendEquationSeparate(ot[se],ot[me]),y=se,P=me),(te!==C||we!==b||Se!==A||Ge!==x)&&(n.blendFuncSeparate(tt[te],tt[we],tt[Se],tt[Ge]),C=te,b=we,A=Se,x=Ge),(Ze.equals(T)===!1||ae!==B)&&(n.blendColor(Ze.r,Ze.g,Ze.b,ae),T.copy(Ze),B=ae),m=U,D=!1}function Ft(U,se){U.side===Ki?He(n.CULL_FACE):Me(n.CULL_FACE);let te=U.side===Zn;se&&(te=!te),an(te),U.blending===go&&U.transparent===!1?qt(ur):qt(U.blending,U.blendEquation,U.blendSrc,U.blendDst,U.blendEquationAlpha,U.blendSrcAlpha,U.blendDstAlpha,U.blendColor,U.blendAlpha,U.premultipliedAlpha),o.setFunc(U.depthFunc),o.setTest(U.depthTest),o.setMask(U.depthWrite),r.setMask(U.colorWrite);let we=U.stencilWrite;a.setTest(we),we&&(a.setMask(U.stencilWriteMask),a.setFunc(U.stencilFunc,U.stencilRef,U.stencilFuncMask),a.setOp(U.stencilFail,U.stencilZFail,U.stencilZPass)),xt(U.polygonOffset,U.polygonOffsetFactor,U.polygonOffsetUnits),U.alphaToCoverage===!0?Me(n.SAMPLE_ALPHA_TO_COVERAGE):He(n.SAMPLE_ALPHA_TO_COVERAGE)}function an(U){I!==U&&(U?n.frontFace(n.CW):n.frontFace(n.CCW),I=U)}function Pt(U){U!==bp?(Me(n.CULL_FACE),U!==k&&(U===bh?n.cullFace(n.BACK):U===wp?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):He(n.CULL_FACE),k=U}function wn(U){U!==V&&(G&&n.lineWidth(U),V=U)}function xt(U,se,te){U?(Me(n.POLYGON_OFFSET_FILL),(N!==se||H!==te)&&(N=se,H=te,o.getReversed()&&(se=-se,te=-te),n.polygonOffset(se,te))):He(n.POLYGON_OFFSET_FILL)}function gn(U){U?Me(n.SCISSOR_TEST):He(n.SCISSOR_TEST)}function Kt(U){U===void 0&&(U=n.TEXTURE0+$-1),j!==U&&(n.activeTexture(U),j=U)}function ln(U,se,te){te===void 0&&(j===null?te=n.TEXTURE0+$-1:te=j);let we=ie[te];we===void 0&&(we={type:void 0,texture:void 0},ie[te]=we),(we.type!==U||we.texture!==se)&&(j!==te&&(n.activeTexture(te),j=te),n.bindTexture(U,se||Ee[U]),we.type=U,we.texture=se)}function F(){let U=ie[j];U!==void 0&&U.type!==void 0&&(n.bindTexture(U.type,null),U.type=void 0,U.texture=void 0)}function Re(){try{n.compressedTexImage2D(...arguments)}catch(U){Ke("WebGLState:",U)}}function qe(){try{n.compressedTexImage3D(...arguments)}catch(U){Ke("WebGLState:",U)}}function st(){try{n.texSubImage2D(...arguments)}catch(U){Ke("WebGLState:",U)}}function be(){try{n.texSubImage3D(...arguments)}catch(U){Ke("WebGLState:",U)}}function Nt(){try{n.compressedTexSubImage2D(...arguments)}catch(U){Ke("WebGLState:",U)}}function ze(){try{n.compressedTexSubImage3D(...arguments)}catch(U){Ke("WebGLState:",U)}}function Xe(){try{n.texStorage2D(...arguments)}catch(U){Ke("WebGLState:",U)}}function E(){try{n.texStorage3D(...arguments)}catch(U){Ke("WebGLState:",U)}}function v(){try{n.texImage2D(...arguments)}catch(U){Ke("WebGLState:",U)}}function X(){try{n.texImage3D(...arguments)}catch(U){Ke("WebGLState:",U)}}function ce(U){return h[U]!==void 0?h[U]:n.getParameter(U)}function re(U,se){h[U]!==se&&(n.pixelStorei(U,se),h[U]=se)}function ge(U){Q.equals(U)===!1&&(n.scissor(U.x,U.y,U.z,U.w),Q.copy(U))}function ve(U){pe.equals(U)===!1&&(n.viewport(U.x,U.y,U.z,U.w),pe.copy(U))}function ee(U,se){let te=c.get(se);te===void 0&&(te=new WeakMap,c.set(se,te));let we=te.get(U);we===void 0&&(we=n.getUniformBlockIndex(se,U.name),n.uniformBlockBinding(se,we,we),te.set(U,we))}function ne(U,se,te){let me=c.get(se).get(U);l[me]!==te&&(n.bindBufferBase(n.UNIFORM_BUFFER,me,te),l[me]=te)}function de(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},j=null,ie={},f={},l={},p=new WeakMap,g=[],S=null,d=!1,m=null,y=null,C=null,b=null,P=null,A=null,x=null,T=new je(0,0,0),B=0,D=!1,I=null,k=null,V=null,N=null,H=null,Q.set(0,0,n.canvas.width,n.canvas.height),pe.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Me,disable:He,bindFramebuffer:it,drawBuffers:Ve,useProgram:ct,setBlending:qt,setMaterial:Ft,setFlipSided:an,setCullFace:Pt,setLineWidth:wn,setPolygonOffset:xt,setScissorTest:gn,activeTexture:Kt,bindTexture:ln,unbindTexture:F,compressedTexImage2D:Re,compressedTexImage3D:qe,texImage2D:v,texImage3D:X,pixelStorei:re,getParameter:ce,updateUBOMapping:ee,uniformBlockBinding:ne,texStorage2D:Xe,texStorage3D:E,texSubImage2D:st,texSubImage3D:be,compressedTexSubImage2D:Nt,compressedTexSubImage3D:ze,scissor:ge,viewport:ve,reset:de}}function vw(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ft,u=new WeakMap,h=new Set,f,p=new WeakMap,g=new Set,S=new FinalizationRegistry(E=>g.delete(E)),d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(E,v){return d?new OffscreenCanvas(E,v):na("canvas")}function y(E,v,X){let ce=1,re=Xe(E);if((re.width>X||re.height>X)&&(ce=X/Math.max(re.width,re.height)),ce<1)if(typeof HTMLImageElement<"u"&&E instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&E instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&E instanceof ImageBitmap||typeof VideoFrame<"u"&&E instanceof VideoFrame){let ge=Math.floor(ce*re.width),ve=Math.floor(ce*re.height);f===void 0&&(f=m(ge,ve));let ee=v?m(ge,ve):f;return ee.width=ge,ee.height=ve,ee.getContext("2d").drawImage(E,0,0,ge,ve),$e("WebGLRenderer: Texture has been resized from ("+re.width+"x"+re.height+") to ("+ge+"x"+ve+")."),ee}else return"data"in E&&$e("WebGLRenderer: Image in DataTexture is too big ("+re.width+"x"+re.height+")."),E;return E}function C(E){return E.generateMipmaps}function b(E){n.generateMipmap(E)}function P(E){return E.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:E.isWebGL3DRenderTarget?n.TEXTURE_3D:E.isWebGLArrayRenderTarget||E.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(E,v,X,ce,re,ge=!1){if(E!==null){if(n[E]!==void 0)return n[E];$e("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+E+"'")}let ve;ce&&(ve=e.get("EXT_texture_norm16"),ve||$e("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ee=v;if(v===n.RED&&(X===n.FLOAT&&(ee=n.R32F),X===n.HALF_FLOAT&&(ee=n.R16F),X===n.UNSIGNED_BYTE&&(ee=n.R8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.R16_EXT),X===n.SHORT&&ve&&(ee=ve.R16_SNORM_EXT)),v===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.R8UI),X===n.UNSIGNED_SHORT&&(ee=n.R16UI),X===n.UNSIGNED_INT&&(ee=n.R32UI),X===n.BYTE&&(ee=n.R8I),X===n.SHORT&&(ee=n.R16I),X===n.INT&&(ee=n.R32I)),v===n.RG&&(X===n.FLOAT&&(ee=n.RG32F),X===n.HALF_FLOAT&&(ee=n.RG16F),X===n.UNSIGNED_BYTE&&(ee=n.RG8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RG16_EXT),X===n.SHORT&&ve&&(ee=ve.RG16_SNORM_EXT)),v===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RG8UI),X===n.UNSIGNED_SHORT&&(ee=n.RG16UI),X===n.UNSIGNED_INT&&(ee=n.RG32UI),X===n.BYTE&&(ee=n.RG8I),X===n.SHORT&&(ee=n.RG16I),X===n.INT&&(ee=n.RG32I)),v===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RGB8UI),X===n.UNSIGNED_SHORT&&(ee=n.RGB16UI),X===n.UNSIGNED_INT&&(ee=n.RGB32UI),X===n.BYTE&&(ee=n.RGB8I),X===n.SHORT&&(ee=n.RGB16I),X===n.INT&&(ee=n.RGB32I)),v===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(ee=n.RGBA16UI),X===n.UNSIGNED_INT&&(ee=n.RGBA32UI),X===n.BYTE&&(ee=n.RGBA8I),X===n.SHORT&&(ee=n.RGBA16I),X===n.INT&&(ee=n.RGBA32I)),v===n.RGB&&(X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RGB16_EXT),X===n.SHORT&&ve&&(ee=ve.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(ee=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(ee=n.R11F_G11F_B10F)),v===n.RGBA){let ne=ge?ta:mt.getTransfer(re);X===n.FLOAT&&(ee=n.RGBA32F),X===n.HALF_FLOAT&&(ee=n.RGBA16F),X===n.UNSIGNED_BYTE&&(ee=ne===wt?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RGBA16_EXT),X===n.SHORT&&ve&&(ee=ve.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(ee=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(ee=n.RGB5_A1)}return(ee===n.R16F||ee===n.R32F||ee===n.RG16F||ee===n.RG32F||ee===n.RGBA16F||ee===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ee}function x(E,v){let X;return E?v===null||v===Ni||v===dr?X=n.DEPTH24_STENCIL8:v===yi?X=n.DEPTH32F_STENCIL8:v===xo&&(X=n.DEPTH24_STENCIL8,$e("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===Ni||v===dr?X=n.DEPTH_COMPONENT24:v===yi?X=n.DEPTH_COMPONENT32F:v===xo&&(X=n.DEPTH_COMPONENT16),X}function T(E,v){return C(E)===!0||E.isFramebufferTexture&&E.minFilter!==Pn&&E.minFilter!==Yn?Math.log2(Math.max(v.width,v.height))+1:E.mipmaps.length>0?E.mipmaps.length:E.isCompressedTexture&&Array.isArray(E.image)?v.mipmaps.length:1}function B(E){let v=new WeakRef(E);i.get(E).__ref=v,g.add(v),S.register(E,v,v)}function D(E){let v=i.get(E).__ref;v!==void 0&&(g.delete(v),S.unregister(v))}function I(E){V(E.target)}function k(E){N(E.target)}function V(E){E.removeEventListener("dispose",I),D(E),$(E),E.isVideoTexture&&u.delete(E),E.isHTMLTexture&&h.delete(E)}function N(E){E.removeEventListener("dispose",k),D(E),le(E)}function H(){for(let E of g){let v=E.deref();v!==void 0&&(v.isRenderTarget===!0?N(v):V(v))}g.clear(),h.clear()}function $(E){let v=i.get(E);if(v.__webglInit===void 0)return;let X=E.source,ce=p.get(X);if(ce){let re=ce[v.__cacheKey];re.usedTimes--,re.usedTimes===0&&G(E),Object.keys(ce).length===0&&p.delete(X)}i.remove(E)}function G(E){let v=i.get(E);n.deleteTexture(v.__webglTexture);let X=E.source,ce=p.get(X);delete ce[v.__cacheKey],o.memory.textures--}function le(E){let v=i.get(E);v.__depthDisposeCallback&&v.__depthDisposeCallback();let X=E.depthTexture;if(X&&X.renderTarget===E&&V(X),E.isWebGLCubeRenderTarget)for(let re=0;re<6;re++){if(Array.isArray(v.__webglFramebuffer[re]))for(let ge=0;ge<v.__webglFramebuffer[re].length;ge++)n.deleteFramebuffer(v.__webglFramebuffer[re][ge]);else n.deleteFramebuffer(v.__webglFramebuffer[re]);v.__webglDepthbuffer&&n.deleteRenderbuffer(v.__webglDepthbuffer[re])}else{if(Array.isArray(v.__webglFramebuffer))for(let re=0;re<v.__webglFramebuffer.length;re++)n.deleteFramebuffer(v.__webglFramebuffer[re]);else n.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&n.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&n.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let re=0;re<v.__webglColorRenderbuffer.length;re++)v.__webglColorRenderbuffer[re]&&n.deleteRenderbuffer(v.__webglColorRenderbuffer[re]);v.__webglDepthRenderbuffer&&n.deleteRenderbuffer(v.__webglDepthRenderbuffer)}let ce=E.textures;for(let re=0,ge=ce.length;re<ge;re++){let ve=i.get(ce[re]);ve.__webglTexture&&(n.deleteTexture(ve.__webglTexture),o.memory.textures--),i.remove(ce[re])}i.remove(E)}let J=0;function j(){J=0}function ie(){return J}function he(E){J=E}function ue(){let E=J;return E>=s.maxTextures&&$e("WebGLTextures: Trying to use "+(E+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,E}function Q(E){let v=[];return v.push(E.wrapS),v.push(E.wrapT),v.push(E.wrapR||0),v.push(E.magFilter),v.push(E.minFilter),v.push(E.anisotropy),v.push(E.internalFormat),v.push(E.format),v.push(E.type),v.push(E.generateMipmaps),v.push(E.mipmapsAutoUpdate),v.push(E.premultiplyAlpha),v.push(E.flipY),v.push(E.unpackAlignment),v.push(E.colorSpace),v.join()}function pe(E,v){let X=i.get(E);if(E.isVideoTexture&&Nt(E),E.isRenderTargetTexture===!1&&E.isExternalTexture!==!0&&E.version>0&&X.__version!==E.version){let ce=E.image;if(ce===null)$e("WebGLRenderer: Texture marked for update but no image data found.");else if(ce.complete===!1)$e("WebGLRenderer: Texture marked for update but image is incomplete");else{Ft(X,E,v);return}}else E.isExternalTexture&&(X.__webglTexture=E.sourceTexture?E.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+v)}function xe(E,v){let X=i.get(E);if(E.isRenderTargetTexture===!1&&E.version>0&&X.__version!==E.version){Ft(X,E,v);return}else E.isExternalTexture&&(X.__webglTexture=E.sourceTexture?E.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+v)}function Ee(E,v){let X=i.get(E);if(E.isRenderTargetTexture===!1&&E.version>0&&X.__version!==E.version){Ft(X,E,v);return}t.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+v)}function Me(E,v){let X=i.get(E);if(E.version>0&&X.__version!==E.version){an(X,E,v);return}t.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+v)}let He={[kl]:n.REPEAT,[$i]:n.CLAMP_TO_EDGE,[zl]:n.MIRRORED_REPEAT},it={[Pn]:n.NEAREST,[qp]:n.NEAREST_MIPMAP_NEAREST,[Ma]:n.NEAREST_MIPMAP_LINEAR,[Yn]:n.LINEAR,[dc]:n.LINEAR_MIPMAP_NEAREST,[vs]:n.LINEAR_MIPMAP_LINEAR},Ve={[Jp]:n.NEVER,[Xh]:n.ALWAYS,[Kp]:n.LESS,[Hh]:n.LEQUAL,[jp]:n.EQUAL,[Wh]:n.GEQUAL,[Qp]:n.GREATER,[em]:n.NOTEQUAL};function ct(E,v){if(v.type===yi&&e.has("OES_texture_float_linear")===!1&&(v.magFilter===Yn||v.magFilter===dc||v.magFilter===Ma||v.magFilter===vs||v.minFilter===Yn||v.minFilter===dc||v.minFilter===Ma||v.minFilter===vs)&&$e("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(E,n.TEXTURE_WRAP_S,He[v.wrapS]),n.texParameteri(E,n.TEXTURE_WRAP_T,He[v.wrapT]),(E===n.TEXTURE_3D||E===n.TEXTURE_2D_ARRAY)&&n.texParameteri(E,n.TEXTURE_WRAP_R,He[v.wrapR]),n.texParameteri(E,n.TEXTURE_MAG_FILTER,it[v.magFilter]),n.texParameteri(E,n.TEXTURE_MIN_FILTER,it[v.minFilter]),v.compareFunction&&(n.texParameteri(E,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(E,n.TEXTURE_COMPARE_FUNC,Ve[v.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===Pn||v.minFilter!==Ma&&v.minFilter!==vs||v.type===yi&&e.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||i.get(v).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");n.texParameterf(E,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,s.getMaxAnisotropy())),i.get(v).__currentAnisotropy=v.anisotropy}}}function ot(E,v){let X=!1;E.__webglInit===void 0&&(E.__webglInit=!0,v.addEventListener("dispose",I),B(v));let ce=v.source,re=p.get(ce);re===void 0&&(re={},p.set(ce,re));let ge=Q(v);if(ge!==E.__cacheKey){re[ge]===void 0&&(re[ge]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),re[ge].usedTimes++;let ve=re[E.__cacheKey];ve!==void 0&&(re[E.__cacheKey].usedTimes--,ve.usedTimes===0&&G(v)),E.__cacheKey=ge,E.__webglTexture=re[ge].texture}return X}function tt(E,v,X){return Math.floor(Math.floor(E/X)/v)}function qt(E,v,X,ce){let ge=E.updateRanges;if(ge.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,v.width,v.height,X,ce,v.data);else{ge.sort((U,se)=>U.start-se.start);let ve=0;for(let U=1;U<ge.length;U++){let se=ge[ve],te=ge[U],we=se.start+se.count,me=tt(te.start,v.width,4),Se=tt(se.start,v.width,4);te.start<=we+1&&me===Se&&tt(te.start+te.count-1,v.width,4)===me?se.count=Math.max(se.count,te.start+te.count-se.start):(++ve,ge[ve]=te)}ge.length=ve+1;let ee=t.getParameter(n.UNPACK_ROW_LENGTH),ne=t.getParameter(n.UNPACK_SKIP_PIXELS),de=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,v.width);for(let U=0,se=ge.length;U<se;U++){let te=ge[U],we=Math.floor(te.start/4),me=Math.ceil(te.count/4),Se=we%v.width,Ge=Math.floor(we/v.width),Ze=me,ae=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,Ge),t.texSubImage2D(n.TEXTURE_2D,0,Se,Ge,Ze,ae,X,ce,v.data)}E.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ee),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ne),t.pixelStorei(n.UNPACK_SKIP_ROWS,de)}}function Ft(E,v,X){let ce=n.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(ce=n.TEXTURE_2D_ARRAY),v.isData3DTexture&&(ce=n.TEXTURE_3D);let re=ot(E,v),ge=v.source;t.bindTexture(ce,E.__webglTexture,n.TEXTURE0+X);let ve=i.get(ge);if(ge.version!==ve.__version||re===!0){if(t.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&v.image instanceof ImageBitmap)===!1){let ae=mt.getPrimaries(mt.workingColorSpace),Oe=v.colorSpace===Ss?null:mt.getPrimaries(v.colorSpace),Je=v.colorSpace===Ss||ae===Oe?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,v.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Je)}t.pixelStorei(n.UNPACK_ALIGNMENT,v.unpackAlignment);let ne=y(v.image,!1,s.maxTextureSize);ne=ze(v,ne);let de=r.convert(v.format,v.colorSpace),U=r.convert(v.type),se=A(v.internalFormat,de,U,v.normalized,v.colorSpace,v.isVideoTexture);ct(ce,v);let te,we=v.mipmaps,me=v.isVideoTexture!==!0,Se=ve.__version===void 0||re===!0,Ge=ge.dataReady,Ze=T(v,ne);if(v.isDepthTexture)se=x(v.format===ys,v.type),Se&&(me?t.texStorage2D(n.TEXTURE_2D,1,se,ne.width,ne.height):t.texImage2D(n.TEXTURE_2D,0,se,ne.width,ne.height,0,de,U,null));else if(v.isDataTexture)if(we.length>0){me&&Se&&t.texStorage2D(n.TEXTURE_2D,Ze,se,we[0].width,we[0].height);for(let ae=0,Oe=we.length;ae<Oe;ae++)te=we[ae],me?Ge&&t.texSubImage2D(n.TEXTURE_2D,ae,0,0,te.width,te.height,de,U,te.data):t.texImage2D(n.TEXTURE_2D,ae,se,te.width,te.height,0,de,U,te.data);v.generateMipmaps=!1}else me?(Se&&t.texStorage2D(n.TEXTURE_2D,Ze,se,ne.width,ne.height),Ge&&qt(v,ne,de,U)):t.texImage2D(n.TEXTURE_2D,0,se,ne.width,ne.height,0,de,U,ne.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){me&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ze,se,we[0].width,we[0].height,ne.depth);for(let ae=0,Oe=we.length;ae<Oe;ae++)if(te=we[ae],v.format!==ei)if(de!==null)if(me){if(Ge)if(v.layerUpdates.size>0){let Je=jh(te.width,te.height,v.format,v.type);for(let Ce of v.layerUpdates){let rt=te.data.subarray(Ce*Je/te.data.BYTES_PER_ELEMENT,(Ce+1)*Je/te.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ae,0,0,Ce,te.width,te.height,1,de,rt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ae,0,0,0,te.width,te.height,ne.depth,de,te.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ae,se,te.width,te.height,ne.depth,0,te.data,0,0);else $e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else me?Ge&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ae,0,0,0,te.width,te.height,ne.depth,de,U,te.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ae,se,te.width,te.height,ne.depth,0,de,U,te.data);v.layerUpdates.size>0&&v.clearLayerUpdates()}else{me&&Se&&t.texStorage2D(n.TEXTURE_2D,Ze,se,we[0].width,we[0].height);for(let ae=0,Oe=we.length;ae<Oe;ae++)te=we[ae],v.format!==ei?de!==null?me?Ge&&t.compressedTexSubImage2D(n.TEXTURE_2D,ae,0,0,te.width,te.height,de,te.data):t.compressedTexImage2D(n.TEXTURE_2D,ae,se,te.width,te.height,0,te.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):me?Ge&&t.texSubImage2D(n.TEXTURE_2D,ae,0,0,te.width,te.height,de,U,te.data):t.texImage2D(n.TEXTURE_2D,ae,se,te.width,te.height,0,de,U,te.data)}else if(v.isDataArrayTexture)if(me){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ze,se,ne.width,ne.height,ne.depth),Ge)if(v.layerUpdates.size>0){let ae=jh(ne.width,ne.height,v.format,v.type);for(let Oe of v.layerUpdates){let Je=ne.data.subarray(Oe*ae/ne.data.BYTES_PER_ELEMENT,(Oe+1)*ae/ne.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Oe,ne.width,ne.height,1,de,U,Je)}v.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ne.width,ne.height,ne.depth,de,U,ne.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,se,ne.width,ne.height,ne.depth,0,de,U,ne.data);else if(v.isData3DTexture)me?(Se&&t.texStorage3D(n.TEXTURE_3D,Ze,se,ne.width,ne.height,ne.depth),Ge&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ne.width,ne.height,ne.depth,de,U,ne.data)):t.texImage3D(n.TEXTURE_3D,0,se,ne.width,ne.height,ne.depth,0,de,U,ne.data);else if(v.isFramebufferTexture){if(Se)if(me)t.texStorage2D(n.TEXTURE_2D,Ze,se,ne.width,ne.height);else{let ae=ne.width,Oe=ne.height;for(let Je=0;Je<Ze;Je++)t.texImage2D(n.TEXTURE_2D,Je,se,ae,Oe,0,de,U,null),ae>>=1,Oe>>=1}}else if(v.isHTMLTexture){if("texElementImage2D"in n){let ae=n.canvas;if(ae.hasAttribute("layoutsubtree")||ae.setAttribute("layoutsubtree","true"),ne.parentNode!==ae){ae.appendChild(ne),h.add(v),ae.onpaint=Oe=>{let Je=Oe.changedElements;for(let Ce of h)Je.includes(Ce.image)&&(Ce.needsUpdate=!0)},ae.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ne);else{let Je=n.RGBA,Ce=n.RGBA,rt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Je,Ce,rt,ne)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(we.length>0){if(me&&Se){let ae=Xe(we[0]);t.texStorage2D(n.TEXTURE_2D,Ze,se,ae.width,ae.height)}for(let ae=0,Oe=we.length;ae<Oe;ae++)te=we[ae],me?Ge&&t.texSubImage2D(n.TEXTURE_2D,ae,0,0,de,U,te):t.texImage2D(n.TEXTURE_2D,ae,se,de,U,te);v.generateMipmaps=!1}else if(me){if(Se){let ae=Xe(ne);t.texStorage2D(n.TEXTURE_2D,Ze,se,ae.width,ae.height)}Ge&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,de,U,ne)}else t.texImage2D(n.TEXTURE_2D,0,se,de,U,ne);C(v)&&v.mipmapsAutoUpdate===!0&&b(ce),ve.__version=ge.version,v.onUpdate&&v.onUpdate(v)}E.__version=v.version}function an(E,v,X){if(v.image.length!==6)return;let ce=ot(E,v),re=v.source;t.bindTexture(n.TEXTURE_CUBE_MAP,E.__webglTexture,n.TEXTURE0+X);let ge=i.get(re);if(re.version!==ge.__version||ce===!0){t.activeTexture(n.TEXTURE0+X);let ve=mt.getPrimaries(mt.workingColorSpace),ee=v.colorSpace===Ss?null:mt.getPrimaries(v.colorSpace),ne=v.colorSpace===Ss||ve===ee?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,v.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,v.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne);let de=v.isCompressedTexture||v.image[0].isCompressedTexture,U=v.image[0]&&v.image[0].isDataTexture,se=[];for(let Ce=0;Ce<6;Ce++)!de&&!U?se[Ce]=y(v.image[Ce],!0,s.maxCubemapSize):se[Ce]=U?v.image[Ce].image:v.image[Ce],se[Ce]=ze(v,se[Ce]);let te=se[0],we=r.convert(v.format,v.colorSpace),me=r.convert(v.type),Se=A(v.internalFormat,we,me,v.normalized,v.colorSpace),Ge=v.isVideoTexture!==!0,Ze=ge.__version===void 0||ce===!0,ae=re.dataReady,Oe=T(v,te);ct(n.TEXTURE_CUBE_MAP,v);let Je;if(v.isDepthTexture){if(Se=x(v.format===ys,v.type),Ze)if(Ge)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,te.width,te.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,te.width,te.height,0,we,me,null)}else if(de){Ge&&Ze&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Oe,Se,te.width,te.height);for(let Ce=0;Ce<6;Ce++){Je=se[Ce].mipmaps;for(let rt=0;rt<Je.length;rt++){let kt=Je[rt];v.format!==ei?we!==null?Ge?ae&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,rt,0,0,kt.width,kt.height,we,kt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,rt,Se,kt.width,kt.height,0,kt.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ge?ae&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,rt,0,0,kt.width,kt.height,we,me,kt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,rt,Se,kt.width,kt.height,0,we,me,kt.data)}}}else{if(Je=v.mipmaps,Ge&&Ze){Je.length>0&&Oe++;let Ce=Xe(se[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Oe,Se,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(U){Ge?ae&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,se[Ce].width,se[Ce].height,we,me,se[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,se[Ce].width,se[Ce].height,0,we,me,se[Ce].data);for(let rt=0;rt<Je.length;rt++){let Vn=Je[rt].image[Ce].image;Ge?ae&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,rt+1,0,0,Vn.width,Vn.height,we,me,Vn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,rt+1,Se,Vn.width,Vn.height,0,we,me,Vn.data)}}else{Ge?ae&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,we,me,se[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,we,me,se[Ce]);for(let rt=0;rt<Je.length;rt++){let kt=Je[rt];Ge?ae&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,rt+1,0,0,we,me,kt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,rt+1,Se,we,me,kt.image[Ce])}}}C(v)&&v.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),ge.__version=re.version,v.onUpdate&&v.onUpdate(v)}E.__version=v.version}function Pt(E,v,X,ce,re,ge){let ve=r.convert(X.format,X.colorSpace),ee=r.convert(X.type),ne=A(X.internalFormat,ve,ee,X.normalized,X.colorSpace),de=i.get(v),U=i.get(X);if(U.__renderTarget=v,!de.__hasExternalTextures){let se=Math.max(1,v.width>>ge),te=Math.max(1,v.height>>ge);re===n.TEXTURE_3D||re===n.TEXTURE_2D_ARRAY?t.texImage3D(re,ge,ne,se,te,v.depth,0,ve,ee,null):t.texImage2D(re,ge,ne,se,te,0,ve,ee,null)}t.bindFramebuffer(n.FRAMEBUFFER,E),be(v)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ce,re,U.__webglTexture,0,st(v)):(re===n.TEXTURE_2D||re>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&re<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ce,re,U.__webglTexture,ge),t.bindFramebuffer(n.FRAMEBUFFER,null)}function wn(E,v,X){if(n.bindRenderbuffer(n.RENDERBUFFER,E),v.depthBuffer){let ce=v.depthTexture,re=ce&&ce.isDepthTexture?ce.type:null,ge=x(v.stencilBuffer,re),ve=v.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;be(v)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,st(v),ge,v.width,v.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,st(v),ge,v.width,v.height):n.renderbufferStorage(n.RENDERBUFFER,ge,v.width,v.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ve,n.RENDERBUFFER,E)}else{let ce=v.textures;for(let re=0;re<ce.length;re++){let ge=ce[re],ve=r.convert(ge.format,ge.colorSpace),ee=r.convert(ge.type),ne=A(ge.internalFormat,ve,ee,ge.normalized,ge.colorSpace);be(v)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,st(v),ne,v.width,v.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,st(v),ne,v.width,v.height):n.renderbufferStorage(n.RENDERBUFFER,ne,v.width,v.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function xt(E,v,X){let ce=v.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,E),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let re=i.get(v.depthTexture);re.__renderTarget=v;let ge=ce?v.depthTexture.image[0]:v.depthTexture.image;(!re.__webglTexture||ge.width!==v.width||ge.height!==v.height)&&(ge.width=v.width,ge.height=v.height,v.depthTexture.needsUpdate=!0),ce?Me(v.depthTexture,0):pe(v.depthTexture,0);let ve=re.__webglTexture,ee=st(v),ne=ce?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,de=v.depthTexture.format===ys?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(v.depthTexture.format===ps)be(v)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,de,ne,ve,0,ee):n.framebufferTexture2D(n.FRAMEBUFFER,de,ne,ve,0);else if(v.depthTexture.format===ys)be(v)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,de,ne,ve,0,ee):n.framebufferTexture2D(n.FRAMEBUFFER,de,ne,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function gn(E){let v=i.get(E),X=E.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==E.depthTexture){let ce=E.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),ce){let re=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,ce.removeEventListener("dispose",re)};ce.addEventListener("dispose",re),v.__depthDisposeCallback=re}v.__boundDepthTexture=ce}if(E.depthTexture&&!v.__autoAllocateDepthBuffer)if(X)for(let ce=0;ce<6;ce++)xt(v.__webglFramebuffer[ce],E,ce);else E.texture.mipmaps.length>0?xt(v.__webglFramebuffer[0],E,0):xt(v.__webglFramebuffer,E,0);else if(X){v.__webglDepthbuffer=[];for(let ce=0;ce<6;ce++)if(t.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer[ce]),v.__webglDepthbuffer[ce]===void 0)v.__webglDepthbuffer[ce]=n.createRenderbuffer(),wn(v.__webglDepthbuffer[ce],E,!1);else{let re=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ge=v.__webglDepthbuffer[ce];n.bindRenderbuffer(n.RENDERBUFFER,ge),n.framebufferRenderbuffer(n.FRAMEBUFFER,re,n.RENDERBUFFER,ge)}}else if(E.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=n.createRenderbuffer(),wn(v.__webglDepthbuffer,E,!1);else{let re=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ge=v.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ge),n.framebufferRenderbuffer(n.FRAMEBUFFER,re,n.RENDERBUFFER,ge)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Kt(E,v,X){let ce=i.get(E);v!==void 0&&Pt(ce.__webglFramebuffer,E,E.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&gn(E)}function ln(E){let v=E.texture,X=i.get(E),ce=i.get(v);E.addEventListener("dispose",k),B(E);let re=E.textures,ge=E.isWebGLCubeRenderTarget===!0,ve=re.length>1;if(ve||(ce.__webglTexture===void 0&&(ce.__webglTexture=n.createTexture()),ce.__version=v.version,o.memory.textures++),ge){X.__webglFramebuffer=[];for(let ee=0;ee<6;ee++)if(v.mipmaps.length>0){X.__webglFramebuffer[ee]=[];for(let ne=0;ne<v.mipmaps.length;ne++)X.__webglFramebuffer[ee][ne]=n.createFramebuffer()}else X.__webglFramebuffer[ee]=n.createFramebuffer()}else{if(v.mipmaps.length>0){X.__webglFramebuffer=[];for(let ee=0;ee<v.mipmaps.length;ee++)X.__webglFramebuffer[ee]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(ve)for(let ee=0,ne=re.length;ee<ne;ee++){let de=i.get(re[ee]);de.__webglTexture===void 0&&(de.__webglTexture=n.createTexture(),o.memory.textures++)}if(E.samples>0&&be(E)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let ee=0;ee<re.length;ee++){let ne=re[ee];X.__webglColorRenderbuffer[ee]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[ee]);let de=r.convert(ne.format,ne.colorSpace),U=r.convert(ne.type),se=A(ne.internalFormat,de,U,ne.normalized,ne.colorSpace,E.isXRRenderTarget===!0),te=st(E);n.renderbufferStorageMultisample(n.RENDERBUFFER,te,se,E.width,E.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ee,n.RENDERBUFFER,X.__webglColorRenderbuffer[ee])}n.bindRenderbuffer(n.RENDERBUFFER,null),E.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),wn(X.__webglDepthRenderbuffer,E,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ge){t.bindTexture(n.TEXTURE_CUBE_MAP,ce.__webglTexture),ct(n.TEXTURE_CUBE_MAP,v);for(let ee=0;ee<6;ee++)if(v.mipmaps.length>0)for(let ne=0;ne<v.mipmaps.length;ne++)Pt(X.__webglFramebuffer[ee][ne],E,v,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ee,ne);else Pt(X.__webglFramebuffer[ee],E,v,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ee,0);C(v)?b(n.TEXTURE_CUBE_MAP):v.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let ee=0,ne=re.length;ee<ne;ee++){let de=re[ee],U=i.get(de),se=n.TEXTURE_2D;(E.isWebGL3DRenderTarget||E.isWebGLArrayRenderTarget)&&(se=E.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(se,U.__webglTexture),ct(se,de),Pt(X.__webglFramebuffer,E,de,n.COLOR_ATTACHMENT0+ee,se,0),C(de)&&b(se)}t.unbindTexture()}else{let ee=n.TEXTURE_2D;if((E.isWebGL3DRenderTarget||E.isWebGLArrayRenderTarget)&&(ee=E.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ee,ce.__webglTexture),ct(ee,v),v.mipmaps.length>0)for(let ne=0;ne<v.mipmaps.length;ne++)Pt(X.__webglFramebuffer[ne],E,v,n.COLOR_ATTACHMENT0,ee,ne);else Pt(X.__webglFramebuffer,E,v,n.COLOR_ATTACHMENT0,ee,0);C(v)?b(ee):v.mipmaps.length>0&&n.texParameteri(ee,n.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),t.unbindTexture()}E.depthBuffer&&gn(E)}function F(E){let v=E.textures;for(let X=0,ce=v.length;X<ce;X++){let re=v[X];if(C(re)&&re.mipmapsAutoUpdate===!0){let ge=P(E),ve=i.get(re).__webglTexture;t.bindTexture(ge,ve),b(ge),t.unbindTexture()}}}let Re=[];function qe(E){if(E.samples>0){if(be(E)===!1){let v=E.textures,X=E.width,ce=E.height,re=n.COLOR_BUFFER_BIT,ge=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=i.get(E),ee=v.length>1;if(ee)for(let de=0;de<v.length;de++)t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+de,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+de,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),E.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let de=0;de<v.length;de++){if(E.resolveDepthBuffer&&(E.depthBuffer&&(re|=n.DEPTH_BUFFER_BIT),E.stencilBuffer&&E.resolveStencilBuffer&&(re|=n.STENCIL_BUFFER_BIT)),ee){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ve.__webglColorRenderbuffer[de]);let U=i.get(v[de]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,U,0)}n.blitFramebuffer(0,0,X,ce,0,0,X,ce,re,n.NEAREST),l===!0&&(Re.length=0,Re.push(n.COLOR_ATTACHMENT0+de),E.depthBuffer&&E.storeMultisampledDepthBuffer===!1&&Re.push(ge),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ee)for(let de=0;de<v.length;de++){t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+de,n.RENDERBUFFER,ve.__webglColorRenderbuffer[de]);let U=i.get(v[de]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+de,n.TEXTURE_2D,U,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(E.depthBuffer&&E.storeMultisampledDepthBuffer===!1&&l){let v=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[v])}}}function st(E){return Math.min(s.maxSamples,E.samples)}function be(E){let v=i.get(E);return E.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function Nt(E){let v=o.render.frame;u.get(E)!==v&&(u.set(E,v),E.update())}function ze(E,v){let X=E.colorSpace,ce=E.format,re=E.type;return E.isCompressedTexture===!0||E.isVideoTexture===!0||X!==ea&&X!==Ss&&(mt.getTransfer(X)===wt?(ce!==ei||re!==kn)&&$e("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ke("WebGLTextures: Unsupported texture color space:",X)),v}function Xe(E){return typeof HTMLImageElement<"u"&&E instanceof HTMLImageElement?(c.width=E.naturalWidth||E.width,c.height=E.naturalHeight||E.height):typeof VideoFrame<"u"&&E instanceof VideoFrame?(c.width=E.displayWidth,c.height=E.displayHeight):(c.width=E.width,c.height=E.height),c}this.allocateTextureUnit=ue,this.resetTextureUnits=j,this.getTextureUnits=ie,this.setTextureUnits=he,this.setTexture2D=pe,this.setTexture2DArray=xe,this.setTexture3D=Ee,this.setTextureCube=Me,this.rebindTextures=Kt,this.setupRenderTarget=ln,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=qe,this.setupDepthRenderbuffer=gn,this.setupFrameBufferTexture=Pt,this.useMultisampledRTT=be,this.dispose=H}function yw(n,e){function t(i,s=Ss){let r,o=mt.getTransfer(s);if(i===kn)return n.UNSIGNED_BYTE;if(i===mc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===gc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===kh)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===zh)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Oh)return n.BYTE;if(i===Bh)return n.SHORT;if(i===xo)return n.UNSIGNED_SHORT;if(i===pc)return n.INT;if(i===Ni)return n.UNSIGNED_INT;if(i===yi)return n.FLOAT;if(i===Di)return n.HALF_FLOAT;if(i===Vh)return n.ALPHA;if(i===Gh)return n.RGB;if(i===ei)return n.RGBA;if(i===ps)return n.DEPTH_COMPONENT;if(i===ys)return n.DEPTH_STENCIL;if(i===vo)return n.RED;if(i===_c)return n.RED_INTEGER;if(i===qs)return n.RG;if(i===xc)return n.RG_INTEGER;if(i===vc)return n.RGBA_INTEGER;if(i===ba||i===wa||i===Ta||i===Aa)if(o===wt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===ba)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ta)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Aa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===ba)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===wa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ta)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Aa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===yc||i===Sc||i===Mc||i===bc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===yc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Sc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Mc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===bc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===wc||i===Tc||i===Ac||i===Ec||i===Cc||i===Ea||i===Rc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===wc||i===Tc)return o===wt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Ac)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Ec)return r.COMPRESSED_R11_EAC;if(i===Cc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Ea)return r.COMPRESSED_RG11_EAC;if(i===Rc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Pc||i===Ic||i===Lc||i===Nc||i===Dc||i===Uc||i===Fc||i===Oc||i===Bc||i===kc||i===zc||i===Vc||i===Gc||i===Hc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Pc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ic)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Lc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Nc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Dc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Uc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Fc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Oc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Bc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===kc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===zc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Vc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Gc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Hc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Wc||i===Xc||i===qc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Wc)return o===wt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Xc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===qc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===$c||i===Yc||i===Ca||i===Zc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===$c)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Yc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ca)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Zc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===dr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var Sw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Mw=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,lf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new fa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new vi({vertexShader:Sw,fragmentShader:Mw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Wt(new ar(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},cf=class extends Yi{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,p=null,g=null,S=typeof XRWebGLBinding<"u",d=new lf,m={},y=t.getContextAttributes(),C=null,b=null,P=[],A=[],x=new ft,T=null,B=null,D=new $n;D.viewport=new Ot;let I=new $n;I.viewport=new Ot;let k=[D,I],V=new uc,N=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let pe=P[Q];return pe===void 0&&(pe=new ao,P[Q]=pe),pe.getTargetRaySpace()},this.getControllerGrip=function(Q){let pe=P[Q];return pe===void 0&&(pe=new ao,P[Q]=pe),pe.getGripSpace()},this.getHand=function(Q){let pe=P[Q];return pe===void 0&&(pe=new ao,P[Q]=pe),pe.getHandSpace()};function $(Q){let pe=A.indexOf(Q.inputSource);if(pe===-1)return;let xe=P[pe];xe!==void 0&&(xe.update(Q.inputSource,Q.frame,c||o),xe.dispatchEvent({type:Q.type,data:Q.inputSource}))}function G(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",le);for(let Q=0;Q<P.length;Q++){let pe=A[Q];pe!==null&&(A[Q]=null,P[Q].disconnect(pe))}N=null,H=null,d.reset();for(let Q in m)delete m[Q];if(e.setRenderTarget(C),p=null,f=null,h=null,s=null,b=null,ue.stop(),i.isPresenting=!1,e.setPixelRatio(T),e.setSize(x.width,x.height,!1),B!==null){let Q=B.camera;Q.fov=B.fov,Q.zoom=B.zoom,Q.updateProjectionMatrix(),B=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,i.isPresenting===!0&&$e("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,i.isPresenting===!0&&$e("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return h===null&&S&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(C=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",G),s.addEventListener("inputsourceschange",le),y.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(x),S&&"createProjectionLayer"in XRWebGLBinding.prototype){let xe=null,Ee=null,Me=null;y.depth&&(Me=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,xe=y.stencil?ys:ps,Ee=y.stencil?dr:Ni);let He={colorFormat:t.RGBA8,depthFormat:Me,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(He),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),b=new li(f.textureWidth,f.textureHeight,{format:ei,type:kn,depthTexture:new _s(f.textureWidth,f.textureHeight,Ee,void 0,void 0,void 0,void 0,void 0,void 0,xe),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let xe={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,t,xe),s.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),b=new li(p.framebufferWidth,p.framebufferHeight,{format:ei,type:kn,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ue.setContext(s),ue.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return d.getDepthTexture()};function le(Q){for(let pe=0;pe<Q.removed.length;pe++){let xe=Q.removed[pe],Ee=A.indexOf(xe);Ee>=0&&(A[Ee]=null,P[Ee].disconnect(xe))}for(let pe=0;pe<Q.added.length;pe++){let xe=Q.added[pe],Ee=A.indexOf(xe);if(Ee===-1){for(let He=0;He<P.length;He++)if(He>=A.length){A.push(xe),Ee=He;break}else if(A[He]===null){A[He]=xe,Ee=He;break}if(Ee===-1)break}let Me=P[Ee];Me&&Me.connect(xe)}}function J(Q,pe){pe===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(pe.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let pe=Q.near,xe=Q.far;d.texture!==null&&(d.depthNear>0&&(pe=d.depthNear),d.depthFar>0&&(xe=d.depthFar)),V.near=I.near=D.near=pe,V.far=I.far=D.far=xe,(N!==V.near||H!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),N=V.near,H=V.far),V.layers.mask=Q.layers.mask|6,D.layers.mask=V.layers.mask&-5,I.layers.mask=V.layers.mask&-3;let Ee=Q.parent,Me=V.cameras;J(V,Ee);for(let He=0;He<Me.length;He++)J(Me[He],Ee);V.projectionMatrix.copy(D.projectionMatrix),V.projectionMatrixInverse.copy(D.projectionMatrixInverse),B===null&&Q.isPerspectiveCamera&&(B={camera:Q,fov:Q.fov,zoom:Q.zoom}),j(Q,V,Ee)};function j(Q,pe,xe){xe===null?Q.matrix.copy(pe.matrixWorld):(Q.matrix.copy(xe.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(pe.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(pe.projectionMatrix),Q.projectionMatrixInverse.copy(pe.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Gl*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(Q){l=Q,f!==null&&(f.fixedFoveation=Q),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=Q)},this.hasDepthSensing=function(){return d.texture!==null},this.getDepthSensingMesh=function(){return d.getMesh(V)},this.getCameraTexture=function(Q){return m[Q]};let ie=null;function he(Q,pe){if(u=pe.getViewerPose(c||o),g=pe,u!==null){let xe=u.views;p!==null&&(e.setRenderTargetFramebuffer(b,p.framebuffer),e.setRenderTarget(b));let Ee=!1;xe.length!==V.cameras.length&&(V.cameras.length=0,Ee=!0);for(let Ve=0;Ve<xe.length;Ve++){let ct=xe[Ve],ot=null;if(p!==null)ot=p.getViewport(ct);else{let qt=h.getViewSubImage(f,ct);ot=qt.viewport,Ve===0&&(e.setRenderTargetTextures(b,qt.colorTexture,qt.depthStencilTexture),e.setRenderTarget(b))}let tt=k[Ve];tt===void 0&&(tt=new $n,tt.layers.enable(Ve),tt.viewport=new Ot,k[Ve]=tt),tt.matrix.fromArray(ct.transform.matrix),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.projectionMatrix.fromArray(ct.projectionMatrix),tt.projectionMatrixInverse.copy(tt.projectionMatrix).invert(),tt.viewport.set(ot.x,ot.y,ot.width,ot.height),Ve===0&&(V.matrix.copy(tt.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Ee===!0&&V.cameras.push(tt)}let Me=s.enabledFeatures;if(Me&&Me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&S){h=i.getBinding();let Ve=h.getDepthInformation(xe[0]);Ve&&Ve.isValid&&Ve.texture&&d.init(Ve,s.renderState)}if(Me&&Me.includes("camera-access")&&S){e.state.unbindTexture(),h=i.getBinding();for(let Ve=0;Ve<xe.length;Ve++){let ct=xe[Ve].camera;if(ct){let ot=m[ct];ot||(ot=new fa,m[ct]=ot);let tt=h.getCameraImage(ct);ot.sourceTexture=tt}}}}for(let xe=0;xe<P.length;xe++){let Ee=A[xe],Me=P[xe];Ee!==null&&Me!==void 0&&Me.update(Ee,pe,c||o)}ie&&ie(Q,pe),pe.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:pe}),g=null}let ue=new Lm;ue.setAnimationLoop(he),this.setAnimationLoop=function(Q){ie=Q},this.dispose=function(){}}},bw=new vt,Gm=new et;Gm.set(-1,0,0,0,1,0,0,0,1);function ww(n,e){function t(d,m){d.matrixAutoUpdate===!0&&d.updateMatrix(),m.value.copy(d.matrix)}function i(d,m){m.color.getRGB(d.fogColor.value,Zh(n)),m.isFog?(d.fogNear.value=m.near,d.fogFar.value=m.far):m.isFogExp2&&(d.fogDensity.value=m.density)}function s(d,m,y,C,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(d,m):m.isMeshLambertMaterial?(r(d,m),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(d,m),h(d,m)):m.isMeshPhongMaterial?(r(d,m),u(d,m),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(d,m),f(d,m),m.isMeshPhysicalMaterial&&p(d,m,b)):m.isMeshMatcapMaterial?(r(d,m),g(d,m)):m.isMeshDepthMaterial?r(d,m):m.isMeshDistanceMaterial?(r(d,m),S(d,m)):m.isMeshNormalMaterial?r(d,m):m.isLineBasicMaterial?(o(d,m),m.isLineDashedMaterial&&a(d,m)):m.isPointsMaterial?l(d,m,y,C):m.isSpriteMaterial?c(d,m):m.isShadowMaterial?(d.color.value.copy(m.color),d.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(d,m){d.opacity.value=m.opacity,m.color&&d.diffuse.value.copy(m.color),m.emissive&&d.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(d.map.value=m.map,t(m.map,d.mapTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,t(m.alphaMap,d.alphaMapTransform)),m.bumpMap&&(d.bumpMap.value=m.bumpMap,t(m.bumpMap,d.bumpMapTransform),d.bumpScale.value=m.bumpScale,m.side===Zn&&(d.bumpScale.value*=-1)),m.normalMap&&(d.normalMap.value=m.normalMap,t(m.normalMap,d.normalMapTransform),d.normalScale.value.copy(m.normalScale),m.side===Zn&&d.normalScale.value.negate()),m.displacementMap&&(d.displacementMap.value=m.displacementMap,t(m.displacementMap,d.displacementMapTransform),d.displacementScale.value=m.displacementScale,d.displacementBias.value=m.displacementBias),m.emissiveMap&&(d.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,d.emissiveMapTransform)),m.specularMap&&(d.specularMap.value=m.specularMap,t(m.specularMap,d.specularMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest);let y=e.get(m),C=y.envMap,b=y.envMapRotation;C&&(d.envMap.value=C,d.envMapRotation.value.setFromMatrix4(bw.makeRotationFromEuler(b)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&d.envMapRotation.value.premultiply(Gm),d.reflectivity.value=m.reflectivity,d.ior.value=m.ior,d.refractionRatio.value=m.refractionRatio),m.lightMap&&(d.lightMap.value=m.lightMap,d.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,d.lightMapTransform)),m.aoMap&&(d.aoMap.value=m.aoMap,d.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,d.aoMapTransform))}function o(d,m){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,m.map&&(d.map.value=m.map,t(m.map,d.mapTransform))}function a(d,m){d.dashSize.value=m.dashSize,d.totalSize.value=m.dashSize+m.gapSize,d.scale.value=m.scale}function l(d,m,y,C){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,d.size.value=m.size*y,d.scale.value=C*.5,m.map&&(d.map.value=m.map,t(m.map,d.uvTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,t(m.alphaMap,d.alphaMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest)}function c(d,m){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,d.rotation.value=m.rotation,m.map&&(d.map.value=m.map,t(m.map,d.mapTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,t(m.alphaMap,d.alphaMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest)}function u(d,m){d.specular.value.copy(m.specular),d.shininess.value=Math.max(m.shininess,1e-4)}function h(d,m){m.gradientMap&&(d.gradientMap.value=m.gradientMap)}function f(d,m){d.metalness.value=m.metalness,m.metalnessMap&&(d.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,d.metalnessMapTransform)),d.roughness.value=m.roughness,m.roughnessMap&&(d.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,d.roughnessMapTransform)),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)}function p(d,m,y){d.ior.value=m.ior,m.diffuseRoughness>0&&(d.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(d.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,d.diffuseRoughnessMapTransform))),m.sheen>0&&(d.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),d.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(d.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,d.sheenColorMapTransform)),m.sheenRoughnessMap&&(d.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,d.sheenRoughnessMapTransform))),m.clearcoat>0&&(d.clearcoat.value=m.clearcoat,d.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(d.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,d.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(d.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,d.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(d.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,d.clearcoatNormalMapTransform),d.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Zn&&d.clearcoatNormalScale.value.negate())),m.dispersion>0&&(d.dispersion.value=m.dispersion),m.retroreflectivity>0&&(d.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(d.iridescence.value=m.iridescence,d.iridescenceIOR.value=m.iridescenceIOR,d.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,d.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(d.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,d.iridescenceMapTransform)),m.iridescenceThicknessMap&&(d.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,d.iridescenceThicknessMapTransform))),m.transmission>0&&(d.transmission.value=m.transmission,d.transmissionSamplerMap.value=y.texture,d.transmissionSamplerSize.value.set(y.width,y.height),m.transmissionMap&&(d.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,d.transmissionMapTransform)),d.thickness.value=m.thickness,m.thicknessMap&&(d.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,d.thicknessMapTransform)),d.attenuationDistance.value=m.attenuationDistance,d.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(d.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(d.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,d.anisotropyMapTransform))),d.specularIntensity.value=m.specularIntensity,d.specularColor.value.copy(m.specularColor),m.specularColorMap&&(d.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,d.specularColorMapTransform)),m.specularIntensityMap&&(d.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,d.specularIntensityMapTransform))}function g(d,m){m.matcap&&(d.matcap.value=m.matcap)}function S(d,m){let y=e.get(m).light;d.referencePosition.value.setFromMatrixPosition(y.matrixWorld),d.nearDistance.value=y.shadow.camera.near,d.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function Tw(n,e,t,i){let s={},r={};function o(y,C){let b=C.program;i.uniformBlockBinding(y,b,s[y.id])}function a(y,C){let b=s[y.id];b===void 0&&(g(y),b=l(y),s[y.id]=b,y.addEventListener("dispose",d));let P=C.program;i.updateUBOMapping(y,P);let A=e.render.frame;r[y.id]!==A&&(c(y),r[y.id]=A)}function l(y){let C=n.createBuffer(),b=y.__size,P=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,C),n.bufferData(n.UNIFORM_BUFFER,b,P),n.bindBuffer(n.UNIFORM_BUFFER,null),C}function c(y){let C=s[y.id],b=y.uniforms,P=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,C);for(let A=0,x=b.length;A<x;A++){let T=b[A];if(Array.isArray(T))for(let B=0,D=T.length;B<D;B++)u(T[B],A,B,P);else u(T,A,0,P)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(y,C,b,P){if(f(y,C,b,P)===!0){let A=y.__offset,x=y.value;if(Array.isArray(x)){let T=0;for(let B=0;B<x.length;B++){let D=x[B],I=S(D,!0);h(D,y.__data,T),T+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else h(x,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,y.__data)}}function h(y,C,b){typeof y=="number"||typeof y=="boolean"?C[b]=y:y.isMatrix3?(C[b]=y.elements[0],C[b+1]=y.elements[1],C[b+2]=y.elements[2],C[b+3]=0,C[b+4]=y.elements[3],C[b+5]=y.elements[4],C[b+6]=y.elements[5],C[b+7]=0,C[b+8]=y.elements[6],C[b+9]=y.elements[7],C[b+10]=y.elements[8],C[b+11]=0):ArrayBuffer.isView(y)?C.set(y.subarray(0,C.length-b),b):y.toArray(C,b)}function f(y,C,b,P){let A=y.value,x=C+"_"+b;if(Array.isArray(A)){P[x]===void 0&&(P[x]=[]);let T=P[x],B=!1;for(let D=0;D<A.length;D++)p(A[D],T,D)===!0&&(B=!0);return B}return p(A,P,x)}function p(y,C,b){if(C[b]===void 0)return typeof y=="number"||typeof y=="boolean"?C[b]=y:ArrayBuffer.isView(y)?C[b]=y.slice():C[b]=y.clone(),!0;{let P=C[b];if(typeof y=="number"||typeof y=="boolean"){if(P!==y)return C[b]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(P.equals(y)===!1)return P.copy(y),!0}}return!1}function g(y){let C=y.uniforms,b=0,P=16;for(let x=0,T=C.length;x<T;x++){let B=Array.isArray(C[x])?C[x]:[C[x]];for(let D=0,I=B.length;D<I;D++){let k=B[D],V=Array.isArray(k.value)?k.value:[k.value],N=Array.isArray(C[x])||Array.isArray(k.value),H=b;for(let G=0,le=V.length;G<le;G++){let J=V[G],j=S(J,N),ie=b%P,he=ie%j.boundary,ue=ie+he;b+=he,ue!==0&&P-ue<j.storage&&(b+=P-ue),G===0&&(H=b),b+=j.storage}let $=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new $((b-H)/Float32Array.BYTES_PER_ELEMENT),k.__offset=H}}let A=b%P;return A>0&&(b+=P-A),y.__size=b,y.__cache={},this}function S(y,C){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=16):y.isMatrix3?(b.boundary=16,b.storage=48):y.isMatrix4?(b.boundary=16,b.storage=64):y.isTexture?$e("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(b.boundary=16,b.storage=y.byteLength):$e("WebGLRenderer: Unsupported uniform value type.",y),C===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function d(y){let C=y.target;C.removeEventListener("dispose",d),n.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function m(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:m}}var Aw=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Qi=null;function Ew(){return Qi===null&&(Qi=new or(Aw,16,16,qs,Di),Qi.name="DFG_LUT",Qi.minFilter=Yn,Qi.magFilter=Yn,Qi.wrapS=$i,Qi.wrapT=$i,Qi.generateMipmaps=!1,Qi.needsUpdate=!0),Qi}var eu=class{constructor(e={}){let{canvas:t=nm(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:p=kn}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let S=p,d=new Set([vc,xc,_c]),m=new Set([kn,Ni,xo,dr,mc,gc]),y=new Uint32Array(4),C=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},P=null,A=null,x=[],T=[],B=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ji,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,I=!1,k=null,V=null,N=null,H=null;this._outputColorSpace=qn;let $=0,G=0,le=null,J=-1,j=null,ie=new Ot,he=new Ot,ue=null,Q=new je(0),pe=0,xe=t.width,Ee=t.height,Me=1,He=null,it=null,Ve=new Ot(0,0,xe,Ee),ct=new Ot(0,0,xe,Ee),ot=!1,tt=new zs,qt=new ql,Ft=!1,an=!1,Pt=new vt,wn=new W,xt=new Ot,gn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Kt=!1;function ln(){return le===null?Me:1}let F=i;function Re(w,O){return t.getContext(w,O)}let qe,st,be,Nt,ze,Xe,E,v,X,ce,re,ge,ve,ee,ne,de,U,se,te,we,me,Se,Ge;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Oe,!1),t.addEventListener("webglcontextrestored",Je,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),F===null){let O="webgl2";if(F=Re(O,w),F===null)throw Re(O)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ze()}catch(w){throw t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),Ke("WebGLRenderer: "+w.message),w}function Ze(){qe=new BM(F),qe.init(),me=new yw(F,qe),st=new EM(F,qe,e,me),be=new xw(F,qe),st.reversedDepthBuffer&&f&&be.buffers.depth.setReversed(!0),V=F.createFramebuffer(),N=F.createFramebuffer(),H=F.createFramebuffer(),Nt=new VM(F),ze=new sw,Xe=new vw(F,qe,be,ze,st,me,Nt),E=new OM(D),v=new Hv(F),Se=new TM(F,v),X=new kM(F,v,Nt,Se),ce=new HM(F,X,v,Se,Nt),se=new GM(F,st,Xe),ne=new CM(ze),re=new iw(D,E,qe,st,Se,ne),ge=new ww(D,ze),ve=new ow,ee=new fw(qe),U=new wM(D,E,be,ce,g,l),de=new _w(D,ce,st),Ge=new Tw(F,Nt,st,be),te=new AM(F,qe,Nt),we=new zM(F,qe,Nt),Nt.programs=re.programs,D.capabilities=st,D.extensions=qe,D.properties=ze,D.renderLists=ve,D.shadowMap=de,D.state=be,D.info=Nt}S!==kn&&(B=new XM(S,t.width,t.height,a,s,r));let ae=new cf(D,F);this.xr=ae,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let w=qe.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=qe.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return Me},this.setPixelRatio=function(w){w!==void 0&&(Me=w,this.setSize(xe,Ee,!1))},this.getSize=function(w){return w.set(xe,Ee)},this.setSize=function(w,O,K=!0){if(ae.isPresenting){$e("WebGLRenderer: Can't change size while VR device is presenting.");return}xe=w,Ee=O,t.width=Math.floor(w*Me),t.height=Math.floor(O*Me),K===!0&&(t.style.width=w+"px",t.style.height=O+"px"),B!==null&&B.setSize(t.width,t.height),this.setViewport(0,0,w,O)},this.getDrawingBufferSize=function(w){return w.set(xe*Me,Ee*Me).floor()},this.setDrawingBufferSize=function(w,O,K){xe=w,Ee=O,Me=K,t.width=Math.floor(w*K),t.height=Math.floor(O*K),this.setViewport(0,0,w,O)},this.setEffects=function(w){if(S===kn){Ke("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let O=0;O<w.length;O++)if(w[O].isOutputPass===!0){$e("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(ie)},this.getViewport=function(w){return w.copy(Ve)},this.setViewport=function(w,O,K,q){w.isVector4?Ve.set(w.x,w.y,w.z,w.w):Ve.set(w,O,K,q),be.viewport(ie.copy(Ve).multiplyScalar(ln()).round())},this.getScissor=function(w){return w.copy(ct)},this.setScissor=function(w,O,K,q){w.isVector4?ct.set(w.x,w.y,w.z,w.w):ct.set(w,O,K,q),be.scissor(he.copy(ct).multiplyScalar(ln()).round())},this.getScissorTest=function(){return ot},this.setScissorTest=function(w){be.setScissorTest(ot=w)},this.setOpaqueSort=function(w){He=w},this.setTransparentSort=function(w){it=w},this.getClearColor=function(w){return w.copy(U.getClearColor())},this.setClearColor=function(){U.setClearColor(...arguments)},this.getClearAlpha=function(){return U.getClearAlpha()},this.setClearAlpha=function(){U.setClearAlpha(...arguments)},this.clear=function(w=!0,O=!0,K=!0){let q=0;if(w){let Y=!1;if(le!==null){let Te=le.texture.format;Y=d.has(Te)}if(Y){let Te=le.texture.type,Pe=m.has(Te),Ae=U.getClearColor(),Ie=U.getClearAlpha(),ke=Ae.r,Qe=Ae.g,ut=Ae.b;Pe?(y[0]=ke,y[1]=Qe,y[2]=ut,y[3]=Ie,F.clearBufferuiv(F.COLOR,0,y)):(C[0]=ke,C[1]=Qe,C[2]=ut,C[3]=Ie,F.clearBufferiv(F.COLOR,0,C))}else q|=F.COLOR_BUFFER_BIT}O&&(q|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),K&&(q|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),q!==0&&F.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),k=w},this.dispose=function(){t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),U.dispose(),ve.dispose(),ee.dispose(),Xe.dispose(),ze.dispose(),E.dispose(),ce.dispose(),X.dispose(),Se.dispose(),Ge.dispose(),re.dispose(),ae.dispose(),ae.removeEventListener("sessionstart",il),ae.removeEventListener("sessionend",ki),is.stop()};function Oe(w){w.preventDefault(),$h("WebGLRenderer: Context Lost."),I=!0}function Je(){$h("WebGLRenderer: Context Restored."),I=!1;let w=Nt.autoReset,O=de.enabled,K=de.autoUpdate,q=de.needsUpdate,Y=de.type;Ze(),Nt.autoReset=w,de.enabled=O,de.autoUpdate=K,de.needsUpdate=q,de.type=Y}function Ce(w){Ke("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function rt(w){let O=w.target;O.removeEventListener("dispose",rt),kt(O)}function kt(w){Vn(w),ze.remove(w)}function Vn(w){let O=ze.get(w).programs;O!==void 0&&(O.forEach(function(K){re.releaseProgram(K)}),w.isShaderMaterial&&re.releaseShaderCache(w))}this.renderBufferDirect=function(w,O,K,q,Y,Te){O===null&&(O=gn);let Pe=Y.isMesh&&Y.matrixWorld.determinantAffine()<0,Ae=zo(w,O,K,q,Y);be.setMaterial(q,Pe);let Ie=K.index,ke=1;if(q.wireframe===!0){if(Ie=X.getWireframeAttribute(K),Ie===void 0)return;ke=2}let Qe=K.drawRange,ut=K.attributes.position,Be=Qe.start*ke,ht=(Qe.start+Qe.count)*ke;Te!==null&&(Be=Math.max(Be,Te.start*ke),ht=Math.min(ht,(Te.start+Te.count)*ke)),Ie!==null?(Be=Math.max(Be,0),ht=Math.min(ht,Ie.count)):ut!=null&&(Be=Math.max(Be,0),ht=Math.min(ht,ut.count));let Zt=ht-Be;if(Zt<0||Zt===1/0)return;Se.setup(Y,q,Ae,K,Ie);let Et,Ct=te;if(Ie!==null&&(Et=v.get(Ie),Ct=we,Ct.setIndex(Et)),Y.isMesh)q.wireframe===!0?(be.setLineWidth(q.wireframeLinewidth*ln()),Ct.setMode(F.LINES)):Ct.setMode(F.TRIANGLES);else if(Y.isLine){let _n=q.linewidth;_n===void 0&&(_n=1),be.setLineWidth(_n*ln()),Y.isLineSegments?Ct.setMode(F.LINES):Y.isLineLoop?Ct.setMode(F.LINE_LOOP):Ct.setMode(F.LINE_STRIP)}else Y.isPoints?Ct.setMode(F.POINTS):Y.isSprite&&Ct.setMode(F.TRIANGLES);if(Y.isBatchedMesh)if(qe.get("WEBGL_multi_draw"))Ct.renderMultiDraw(Y._multiDrawStarts,Y._multiDrawCounts,Y._multiDrawCount);else{let _n=Y._multiDrawStarts,Ue=Y._multiDrawCounts,cn=Y._multiDrawCount,pt=Ie?v.get(Ie).bytesPerElement:1,rs=ze.get(q).currentProgram.getUniforms();for(let un=0;un<cn;un++)rs.setValue(F,"_gl_DrawID",un),Ct.render(_n[un]/pt,Ue[un])}else if(Y.isInstancedMesh)Ct.renderInstances(Be,Zt,Y.count);else if(K.isInstancedBufferGeometry){let _n=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,Ue=Math.min(K.instanceCount,_n);Ct.renderInstances(Be,Zt,Ue)}else Ct.render(Be,Zt)};function Oo(w,O,K,q){k!==null&&w.isNodeMaterial&&k.setObject(q,w),Ft===!0&&ne.setState(w,K,!1),w.transparent===!0&&w.side===Ki&&w.forceSinglePass===!1?(w.side=Zn,w.needsUpdate=!0,zi(w,O,q),w.side=Xs,w.needsUpdate=!0,zi(w,O,q),w.side=Ki):zi(w,O,q)}this.compile=function(w,O,K=null){K===null&&(K=w),k!==null&&k.renderStart(w,O,K),A=ee.get(K),A.init(O),T.push(A),K.traverseVisible(function(Y){Y.isLight&&Y.layers.test(O.layers)&&(A.pushLight(Y),Y.castShadow&&A.pushShadow(Y))}),w!==K&&w.traverseVisible(function(Y){Y.isLight&&Y.layers.test(O.layers)&&(A.pushLight(Y),Y.castShadow&&A.pushShadow(Y))}),A.setupLights(),k!==null&&k.updateLights(A.state.lightsArray),an=this.localClippingEnabled,Ft=ne.init(this.clippingPlanes,an),Ft===!0&&ne.setGlobalState(this.clippingPlanes,O),k!==null&&de.render(A.state.shadowsArray,K,O);let q=new Set;return w.traverse(function(Y){if(!(Y.isMesh||Y.isPoints||Y.isLine||Y.isSprite))return;let Te=Y.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let Ae=Te[Pe];Oo(Ae,K,O,Y),q.add(Ae)}else Oo(Te,K,O,Y),q.add(Te)}),A=T.pop(),k!==null&&k.renderEnd(),q},this.compileAsync=function(w,O,K=null){let q=this.compile(w,O,K);return new Promise(Y=>{function Te(){if(q.forEach(function(Pe){let Ie=ze.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&q.delete(Pe)}),q.size===0){Y(w);return}setTimeout(Te,10)}qe.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let Pr=null;function Fu(w){Pr&&Pr(w)}function il(){is.stop()}function ki(){is.start()}let is=new Lm;is.setAnimationLoop(Fu),typeof self<"u"&&is.setContext(self),this.setAnimationLoop=function(w){Pr=w,ae.setAnimationLoop(w),w===null?is.stop():is.start()},ae.addEventListener("sessionstart",il),ae.addEventListener("sessionend",ki),this.render=function(w,O){if(O!==void 0&&O.isCamera!==!0){Ke("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;k!==null&&k.renderStart(w,O);let K=ae.enabled===!0&&ae.isPresenting===!0,q=B!==null&&(le===null||K)&&B.begin(D,le);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),O.parent===null&&O.matrixWorldAutoUpdate===!0&&O.updateMatrixWorld(),ae.enabled===!0&&ae.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(ae.cameraAutoUpdate===!0&&ae.updateCamera(O),O=ae.getCamera()),w.isScene===!0&&w.onBeforeRender(D,w,O,le),A=ee.get(w,T.length),A.init(O),A.state.textureUnits=Xe.getTextureUnits(),T.push(A),Pt.multiplyMatrices(O.projectionMatrix,O.matrixWorldInverse),O.isArrayCamera?qt.setFromArrayCamera(O):tt.setFromProjectionMatrix(Pt,xi,O.reversedDepth),an=this.localClippingEnabled,Ft=ne.init(this.clippingPlanes,an),P=ve.get(w,x.length),P.init(),x.push(P),this.info.render.frame++,ae.enabled===!0&&ae.isPresenting===!0){let Pe=D.xr.getDepthSensingMesh();Pe!==null&&ss(Pe,O,-1/0,D.sortObjects)}ss(w,O,0,D.sortObjects),P.finish(),k!==null&&k.updateLights(A.state.lightsArray),D.sortObjects===!0&&P.sort(He,it),Kt=ae.enabled===!1||ae.isPresenting===!1||ae.hasDepthSensing()===!1,Kt&&U.addToRenderList(P,w),this.info.autoReset===!0&&this.info.reset(),Ft===!0&&ne.beginShadows();let Y=A.state.shadowsArray;if(de.render(Y,w,O),Ft===!0&&ne.endShadows(),(q&&B.hasRenderPass())===!1){let Pe=P.opaque,Ae=P.transmissive;if(A.setupLights(),O.isArrayCamera){let Ie=O.cameras;if(Ae.length>0)for(let ke=0,Qe=Ie.length;ke<Qe;ke++){let ut=Ie[ke];Ti(Pe,Ae,w,ut)}Kt&&U.render(w);for(let ke=0,Qe=Ie.length;ke<Qe;ke++){let ut=Ie[ke];Bo(P,w,ut,ut.viewport)}}else Ae.length>0&&Ti(Pe,Ae,w,O),Kt&&U.render(w),Bo(P,w,O)}le!==null&&G===0&&(Xe.updateMultisampleRenderTarget(le),Xe.updateRenderTargetMipmap(le)),q&&B.end(D),w.isScene===!0&&w.onAfterRender(D,w,O),Se.resetDefaultState(),J=-1,j=null,T.pop(),T.length>0?(A=T[T.length-1],Xe.setTextureUnits(A.state.textureUnits),Ft===!0&&ne.setGlobalState(D.clippingPlanes,A.state.camera)):A=null,x.pop(),x.length>0?P=x[x.length-1]:P=null,k!==null&&k.renderEnd()};function ss(w,O,K,q){if(w.visible===!1)return;if(w.layers.test(O.layers)){if(w.isGroup)K=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(O);else if(w.isLight)A.pushLight(w),w.castShadow&&A.pushShadow(w);else if(w.isSprite){let Pe=O.isArrayCamera?qt:tt;if(!w.frustumCulled||w.intersectsFrustum(Pe)){q&&xt.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Pt);let Ae=ce.update(w),Ie=w.material;Ie.visible&&P.push(w,Ae,Ie,K,xt.z,null,O)}}else if(w.isMesh||w.isLine||w.isPoints){let Pe=O.isArrayCamera?qt:tt;if(!w.frustumCulled||w.intersectsFrustum(Pe)){let Ae=ce.update(w),Ie=w.material;if(q&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),xt.copy(w.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),xt.copy(Ae.boundingSphere.center)),xt.applyMatrix4(w.matrixWorld).applyMatrix4(Pt)),Array.isArray(Ie)){let ke=Ae.groups;for(let Qe=0,ut=ke.length;Qe<ut;Qe++){let Be=ke[Qe],ht=Ie[Be.materialIndex];ht&&ht.visible&&P.push(w,Ae,ht,K,xt.z,Be,O)}}else Ie.visible&&P.push(w,Ae,Ie,K,xt.z,null,O)}}}let Te=w.children;for(let Pe=0,Ae=Te.length;Pe<Ae;Pe++)ss(Te[Pe],O,K,q)}function Bo(w,O,K,q){let{opaque:Y,transmissive:Te,transparent:Pe}=w;A.setupLightsView(K),Ft===!0&&ne.setGlobalState(D.clippingPlanes,K),q&&be.viewport(ie.copy(q)),Y.length>0&&jt(Y,O,K),Te.length>0&&jt(Te,O,K),Pe.length>0&&jt(Pe,O,K),be.buffers.depth.setTest(!0),be.buffers.depth.setMask(!0),be.buffers.color.setMask(!0),be.setPolygonOffset(!1)}function Ti(w,O,K,q){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[q.id]===void 0){let Be=qe.has("EXT_color_buffer_half_float")||qe.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[q.id]=new li(1,1,{generateMipmaps:!0,type:Be?Di:kn,minFilter:vs,samples:Math.max(4,st.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:mt.workingColorSpace})}let Te=A.state.transmissionRenderTarget[q.id],Pe=q.viewport||ie;Te.setSize(Pe.z*D.transmissionResolutionScale,Pe.w*D.transmissionResolutionScale);let Ae=D.getRenderTarget(),Ie=D.getActiveCubeFace(),ke=D.getActiveMipmapLevel();D.setRenderTarget(Te),D.getClearColor(Q),pe=D.getClearAlpha(),pe<1&&D.setClearColor(16777215,.5),D.clear(),Kt&&U.render(K);let Qe=D.toneMapping;D.toneMapping=ji;let ut=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),A.setupLightsView(q),Ft===!0&&ne.setGlobalState(D.clippingPlanes,q),jt(w,K,q),Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te),qe.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let ht=0,Zt=O.length;ht<Zt;ht++){let Et=O[ht],{object:Ct,geometry:_n,material:Ue,group:cn}=Et;if(Ue.side===Ki&&Ct.layers.test(q.layers)){let pt=Ue.side;Ue.side=Zn,Ue.needsUpdate=!0,sn(Ct,K,q,_n,Ue,cn),Ue.side=pt,Ue.needsUpdate=!0,Be=!0}}Be===!0&&(Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te))}D.setRenderTarget(Ae,Ie,ke),D.setClearColor(Q,pe),ut!==void 0&&(q.viewport=ut),D.toneMapping=Qe}function jt(w,O,K){let q=O.isScene===!0?O.overrideMaterial:null;for(let Y=0,Te=w.length;Y<Te;Y++){let Pe=w[Y],{object:Ae,geometry:Ie,group:ke}=Pe,Qe=Pe.material;Qe.allowOverride===!0&&q!==null&&(Qe=q),Ae.layers.test(K.layers)&&sn(Ae,O,K,Ie,Qe,ke)}}function sn(w,O,K,q,Y,Te){k!==null&&Y.isNodeMaterial&&k.setObject(w,Y),w.onBeforeRender(D,O,K,q,Y,Te),w.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),Y.onBeforeRender(D,O,K,q,w,Te),Y.transparent===!0&&Y.side===Ki&&Y.forceSinglePass===!1?(Y.side=Zn,Y.needsUpdate=!0,D.renderBufferDirect(K,O,q,Y,w,Te),Y.side=Xs,Y.needsUpdate=!0,D.renderBufferDirect(K,O,q,Y,w,Te),Y.side=Ki):D.renderBufferDirect(K,O,q,Y,w,Te),w.onAfterRender(D,O,K,q,Y,Te)}function rn(w){let O=0;for(let K of w)K.texture!==null&&O++;return O}function zi(w,O,K){O.isScene!==!0&&(O=gn);let q=ze.get(w),Y=A.state.lights,Te=A.state.shadowsArray,Pe=Y.state.version,Ae=re.getParameters(w,Y.state,Te,O,K,A.state.lightProbeGridArray),Ie=re.getProgramCacheKey(Ae),ke=q.programs;q.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?O.environment:null,q.fog=O.fog;let Qe=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;q.envMap=E.get(w.envMap||q.environment,Qe),q.envMapRotation=q.environment!==null&&w.envMap===null?O.environmentRotation:w.envMapRotation,ke===void 0&&(w.addEventListener("dispose",rt),ke=new Map,q.programs=ke,q.programVariants=new Map);let ut=ke.get(Ie);if(ut!==void 0){if(q.currentProgram===ut&&q.lightsStateVersion===Pe)return ko(w,Ae),ut}else Ae.uniforms=re.getUniforms(w),k!==null&&w.isNodeMaterial&&k.build(w,K,Ae),w.onBeforeCompile(Ae,D),ut=re.acquireProgram(Ae,Ie),ke.set(Ie,ut),q.uniforms=Ae.uniforms;let Be=q.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Be.clippingPlanes=ne.uniform),ko(w,Ae),q.needsLights=Cs(w),q.lightsStateVersion=Pe,q.needsLights&&(Be.ambientLightColor.value=Y.state.ambient,Be.lightProbe.value=Y.state.probe,Be.sunLights.value=Y.state.sun,Be.sunLightShadows.value=Y.state.sunShadow,Be.directionalLights.value=Y.state.directional,Be.directionalLightShadows.value=Y.state.directionalShadow,Be.spotLights.value=Y.state.spot,Be.spotLightShadows.value=Y.state.spotShadow,Be.rectAreaLights.value=Y.state.rectArea,Be.ltc_1.value=Y.state.rectAreaLTC1,Be.ltc_2.value=Y.state.rectAreaLTC2,Be.pointLights.value=Y.state.point,Be.pointLightShadows.value=Y.state.pointShadow,Be.hemisphereLights.value=Y.state.hemi,Be.sunShadowMatrix.value=Y.state.sunShadowMatrix,Be.sunShadowCascade.value=Y.state.sunShadowCascade,Be.directionalShadowMatrix.value=Y.state.directionalShadowMatrix,Be.spotLightMatrix.value=Y.state.spotLightMatrix,Be.spotLightMap.value=Y.state.spotLightMap,Be.pointShadowMatrix.value=Y.state.pointShadowMatrix),q.numLightProbeGrids=rn(A.state.lightProbeGridArray),q.currentProgram=ut,q.uniformsList=null,ut}function ni(w,O,K,q,Y){let Te=ze.get(w),Pe=Te.currentProgram.id+","+q+","+Y,Ae=Te.programVariants.get(Pe);return Ae===void 0?(Ae=zi(w,O,K),Te.programVariants.set(Pe,Ae)):(Te.currentProgram=Ae,Te.uniformsList=null,Te.outputColorSpace=q,Te.toneMapping=Y),Ae}function Es(w){if(w.uniformsList===null){let O=w.currentProgram.getUniforms();w.uniformsList=yo.seqWithValue(O.seq,w.uniforms)}return w.uniformsList}function ko(w,O){let K=ze.get(w);K.outputColorSpace=O.outputColorSpace,K.batching=O.batching,K.batchingColor=O.batchingColor,K.instancing=O.instancing,K.instancingColor=O.instancingColor,K.instancingMorph=O.instancingMorph,K.skinning=O.skinning,K.morphTargets=O.morphTargets,K.morphNormals=O.morphNormals,K.morphColors=O.morphColors,K.morphTargetsCount=O.morphTargetsCount,K.numClippingPlanes=O.numClippingPlanes,K.numIntersection=O.numClipIntersection,K.vertexAlphas=O.vertexAlphas,K.vertexTangents=O.vertexTangents,K.toneMapping=O.toneMapping}function zo(w,O,K,q,Y){O.isScene!==!0&&(O=gn),Xe.resetTextureUnits();let Te=O.fog,Pe=q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial?O.environment:null,Ae=le===null?D.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:mt.workingColorSpace,Ie=q.isMeshStandardMaterial||q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,ke=E.get(q.envMap||Pe,Ie),Qe=q.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,ut=!!K.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),Be=!!K.morphAttributes.position,ht=!!K.morphAttributes.normal,Zt=!!K.morphAttributes.color,Et=ji;q.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Et=D.toneMapping);let Ct=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,_n=Ct!==void 0?Ct.length:0,Ue=ze.get(q),cn=A.state.lights;if(Ft===!0&&(an===!0||w!==j)){let Rt=w===j&&q.id===J;ne.setState(q,w,Rt)}let pt=!1,rs=!1;q.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==cn.state.version||Y.isBatchedMesh&&Ue.batching===!1||!Y.isBatchedMesh&&Ue.batching===!0||Y.isBatchedMesh&&Ue.batchingColor===!0&&Y._colorsTexture===null||Y.isBatchedMesh&&Ue.batchingColor===!1&&Y._colorsTexture!==null||Y.isInstancedMesh&&Ue.instancing===!1||!Y.isInstancedMesh&&Ue.instancing===!0||Y.isSkinnedMesh&&Ue.skinning===!1||!Y.isSkinnedMesh&&Ue.skinning===!0||Y.isInstancedMesh&&Ue.instancingColor===!0&&Y.instanceColor===null||Y.isInstancedMesh&&Ue.instancingColor===!1&&Y.instanceColor!==null||Y.isInstancedMesh&&Ue.instancingMorph===!0&&Y.morphTexture===null||Y.isInstancedMesh&&Ue.instancingMorph===!1&&Y.morphTexture!==null||Ue.envMap!==ke||q.fog===!0&&Ue.fog!==Te||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==ne.numPlanes||Ue.numIntersection!==ne.numIntersection)||Ue.vertexAlphas!==Qe||Ue.vertexTangents!==ut||Ue.morphTargets!==Be||Ue.morphNormals!==ht||Ue.morphColors!==Zt||Ue.morphTargetsCount!==_n||Ue.numLightProbeGrids!==rn(A.state.lightProbeGridArray)?pt=!0:(Ue.outputColorSpace!==Ae||Ue.toneMapping!==Et)&&(rs=!0):(pt=!0,Ue.__version=q.version);let un=Ue.currentProgram;(pt===!0||rs===!0)&&(un=rs===!0?ni(q,O,Y,Ae,Et):zi(q,O,Y),k&&q.isNodeMaterial&&k.onUpdateProgram(q,un,Ue));let Nr=!1,Vi=!1,os=!1,at=un.getUniforms(),Qt=Ue.uniforms;if(be.useProgram(un.program)&&(Nr=!0,Vi=!0,os=!0),q.id!==J&&(J=q.id,Vi=!0),Nr||j!==w){be.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),at.setValue(F,"projectionMatrix",w.projectionMatrix),at.setValue(F,"viewMatrix",w.matrixWorldInverse);let hn=at.map.cameraPosition;hn!==void 0&&hn.setValue(F,wn.setFromMatrixPosition(w.matrixWorld)),st.logarithmicDepthBuffer&&at.setValue(F,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&at.setValue(F,"isOrthographic",w.isOrthographicCamera===!0),j!==w&&(j=w,Vi=!0,os=!0)}if(Ue.needsLights&&(cn.state.sunShadowMap.length>0&&at.setValue(F,"sunShadowMap",cn.state.sunShadowMap,Xe),cn.state.directionalShadowMap.length>0&&at.setValue(F,"directionalShadowMap",cn.state.directionalShadowMap,Xe),cn.state.spotShadowMap.length>0&&at.setValue(F,"spotShadowMap",cn.state.spotShadowMap,Xe),cn.state.pointShadowMap.length>0&&at.setValue(F,"pointShadowMap",cn.state.pointShadowMap,Xe)),Y.isSkinnedMesh){at.setOptional(F,Y,"bindMatrix"),at.setOptional(F,Y,"bindMatrixInverse");let Rt=Y.skeleton;Rt&&(Rt.boneTexture===null&&Rt.computeBoneTexture(),at.setValue(F,"boneTexture",Rt.boneTexture,Xe))}Y.isBatchedMesh&&(at.setOptional(F,Y,"batchingTexture"),at.setValue(F,"batchingTexture",Y._matricesTexture,Xe),at.setOptional(F,Y,"batchingIdTexture"),at.setValue(F,"batchingIdTexture",Y._indirectTexture,Xe),at.setOptional(F,Y,"batchingColorTexture"),Y._colorsTexture!==null&&at.setValue(F,"batchingColorTexture",Y._colorsTexture,Xe));let Gn=K.morphAttributes;if((Gn.position!==void 0||Gn.normal!==void 0||Gn.color!==void 0)&&se.update(Y,K,un),(Vi||Ue.receiveShadow!==Y.receiveShadow)&&(Ue.receiveShadow=Y.receiveShadow,at.setValue(F,"receiveShadow",Y.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&O.environment!==null&&(Qt.envMapIntensity.value=O.environmentIntensity),Qt.dfgLUT!==void 0&&(Qt.dfgLUT.value=Ew()),Vi){if(at.setValue(F,"toneMappingExposure",D.toneMappingExposure),Ue.needsLights&&Ir(Qt,os),Te&&q.fog===!0&&ge.refreshFogUniforms(Qt,Te),ge.refreshMaterialUniforms(Qt,q,Me,Ee,A.state.transmissionRenderTarget[w.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let Rt=b,hn=0;for(let Fn of A.state.lightProbeGridArray)Fn.texture!==null&&(Rt.textures[hn]=Fn.texture,Rt.min[hn]=Fn.boundingBox.min,Rt.max[hn]=Fn.boundingBox.max,Rt.resolution[hn]=Fn.resolution,hn++);for(let Fn in Rt)Rt[Fn].length=hn;Qt.probesSH.value=Rt.textures,Qt.probesMin.value=Rt.min,Qt.probesMax.value=Rt.max,Qt.probesResolution.value=Rt.resolution}yo.upload(F,Es(Ue),Qt,Xe)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(yo.upload(F,Es(Ue),Qt,Xe),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&at.setValue(F,"center",Y.center),at.setValue(F,"modelViewMatrix",Y.modelViewMatrix),at.setValue(F,"normalMatrix",Y.normalMatrix),at.setValue(F,"modelMatrix",Y.matrixWorld),q.uniformsGroups!==void 0){let Rt=q.uniformsGroups;for(let hn=0,Fn=Rt.length;hn<Fn;hn++){let sl=Rt[hn];Ge.update(sl,un),Ge.bind(sl,un)}}return un}function Ir(w,O){w.ambientLightColor.needsUpdate=O,w.lightProbe.needsUpdate=O,w.sunLights.needsUpdate=O,w.sunLightShadows.needsUpdate=O,w.directionalLights.needsUpdate=O,w.directionalLightShadows.needsUpdate=O,w.pointLights.needsUpdate=O,w.pointLightShadows.needsUpdate=O,w.spotLights.needsUpdate=O,w.spotLightShadows.needsUpdate=O,w.rectAreaLights.needsUpdate=O,w.hemisphereLights.needsUpdate=O}function Cs(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(w,O,K){let q=ze.get(w);q.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),ze.get(w.texture).__webglTexture=O,ze.get(w.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:K,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,O){let K=ze.get(w);K.__webglFramebuffer=O,K.__useDefaultFramebuffer=O===void 0},this.setRenderTarget=function(w,O=0,K=0){le=w,$=O,G=K;let q=null,Y=!1,Te=!1;if(w){let Ae=ze.get(w);if(Ae.__useDefaultFramebuffer!==void 0){be.bindFramebuffer(F.FRAMEBUFFER,Ae.__webglFramebuffer),ie.copy(w.viewport),he.copy(w.scissor),ue=w.scissorTest,be.viewport(ie),be.scissor(he),be.setScissorTest(ue),J=-1;return}else if(Ae.__webglFramebuffer===void 0)Xe.setupRenderTarget(w);else if(Ae.__hasExternalTextures)Xe.rebindTextures(w,ze.get(w.texture).__webglTexture,ze.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let Qe=w.depthTexture;if(Ae.__boundDepthTexture!==Qe){if(Qe!==null&&ze.has(Qe)&&(w.width!==Qe.image.width||w.height!==Qe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xe.setupDepthRenderbuffer(w)}}let Ie=w.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Te=!0);let ke=ze.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(ke[O])?q=ke[O][K]:q=ke[O],Y=!0):w.samples>0&&Xe.useMultisampledRTT(w)===!1?q=ze.get(w).__webglMultisampledFramebuffer:Array.isArray(ke)?q=ke[K]:q=ke,ie.copy(w.viewport),he.copy(w.scissor),ue=w.scissorTest}else ie.copy(Ve).multiplyScalar(Me).floor(),he.copy(ct).multiplyScalar(Me).floor(),ue=ot;if(K!==0&&(q=V),be.bindFramebuffer(F.FRAMEBUFFER,q)&&be.drawBuffers(w,q),be.viewport(ie),be.scissor(he),be.setScissorTest(ue),Y){let Ae=ze.get(w.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+O,Ae.__webglTexture,K)}else if(Te){let Ae=O;for(let Ie=0;Ie<w.textures.length;Ie++){let ke=ze.get(w.textures[Ie]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+Ie,ke.__webglTexture,K,Ae)}}else if(w!==null&&K!==0){let Ae=ze.get(w.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ae.__webglTexture,K)}J=-1};function Lr(w){let O=ze.get(w);return(O.__readFormat!==w.format||O.__readType!==w.type)&&(O.__readFormat=w.format,O.__readType=w.type,O.__formatReadable=st.textureFormatReadable(w.format),O.__typeReadable=st.textureTypeReadable(w.type)),O}this.readRenderTargetPixels=function(w,O,K,q,Y,Te,Pe,Ae=0){if(!(w&&w.isWebGLRenderTarget)){Ke("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=ze.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){be.bindFramebuffer(F.FRAMEBUFFER,Ie);try{let ke=w.textures[Ae],Qe=ke.format,ut=ke.type;w.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ae);let Be=Lr(ke);if(Be.__formatReadable===!1){Ke("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){Ke("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}O>=0&&O<=w.width-q&&K>=0&&K<=w.height-Y&&F.readPixels(O,K,q,Y,me.convert(Qe),me.convert(ut),Te)}finally{let ke=le!==null?ze.get(le).__webglFramebuffer:null;be.bindFramebuffer(F.FRAMEBUFFER,ke)}}},this.readRenderTargetPixelsAsync=async function(w,O,K,q,Y,Te,Pe,Ae=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=ze.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(O>=0&&O<=w.width-q&&K>=0&&K<=w.height-Y){be.bindFramebuffer(F.FRAMEBUFFER,Ie);let ke=w.textures[Ae],Qe=ke.format,ut=ke.type;w.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ae);let Be=Lr(ke);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ht=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,ht),F.bufferData(F.PIXEL_PACK_BUFFER,Te.byteLength,F.STREAM_READ),F.readPixels(O,K,q,Y,me.convert(Qe),me.convert(ut),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let Zt=le!==null?ze.get(le).__webglFramebuffer:null;be.bindFramebuffer(F.FRAMEBUFFER,Zt);let Et=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await sm(F,Et,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,ht),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,Te),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(ht),F.deleteSync(Et),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,O=null,K=0){let q=Math.pow(2,-K),Y=Math.floor(w.image.width*q),Te=Math.floor(w.image.height*q),Pe=O!==null?O.x:0,Ae=O!==null?O.y:0;Xe.setTexture2D(w,0),F.copyTexSubImage2D(F.TEXTURE_2D,K,0,0,Pe,Ae,Y,Te),be.unbindTexture()},this.copyTextureToTexture=function(w,O,K=null,q=null,Y=0,Te=0){let Pe,Ae,Ie,ke,Qe,ut,Be,ht,Zt,Et=w.isCompressedTexture?w.mipmaps[Te]:w.image;if(K!==null)Pe=K.max.x-K.min.x,Ae=K.max.y-K.min.y,Ie=K.isBox3?K.max.z-K.min.z:1,ke=K.min.x,Qe=K.min.y,ut=K.isBox3?K.min.z:0;else{let at=Math.pow(2,-Y);Pe=Math.floor(Et.width*at),Ae=Math.floor(Et.height*at),w.isDataArrayTexture?Ie=Et.depth:w.isData3DTexture?Ie=Math.floor(Et.depth*at):Ie=1,ke=0,Qe=0,ut=0}q!==null?(Be=q.x,ht=q.y,Zt=q.z):(Be=0,ht=0,Zt=0);let Ct=me.convert(O.format),_n=me.convert(O.type),Ue;O.isData3DTexture?(Xe.setTexture3D(O,0),Ue=F.TEXTURE_3D):O.isDataArrayTexture||O.isCompressedArrayTexture?(Xe.setTexture2DArray(O,0),Ue=F.TEXTURE_2D_ARRAY):(Xe.setTexture2D(O,0),Ue=F.TEXTURE_2D),be.activeTexture(F.TEXTURE0),be.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,O.flipY),be.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,O.premultiplyAlpha),be.pixelStorei(F.UNPACK_ALIGNMENT,O.unpackAlignment);let cn=be.getParameter(F.UNPACK_ROW_LENGTH),pt=be.getParameter(F.UNPACK_IMAGE_HEIGHT),rs=be.getParameter(F.UNPACK_SKIP_PIXELS),un=be.getParameter(F.UNPACK_SKIP_ROWS),Nr=be.getParameter(F.UNPACK_SKIP_IMAGES);be.pixelStorei(F.UNPACK_ROW_LENGTH,Et.width),be.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Et.height),be.pixelStorei(F.UNPACK_SKIP_PIXELS,ke),be.pixelStorei(F.UNPACK_SKIP_ROWS,Qe),be.pixelStorei(F.UNPACK_SKIP_IMAGES,ut);let Vi=w.isDataArrayTexture||w.isData3DTexture,os=O.isDataArrayTexture||O.isData3DTexture;if(w.isDepthTexture){let at=ze.get(w),Qt=ze.get(O),Gn=ze.get(at.__renderTarget),Rt=ze.get(Qt.__renderTarget);be.bindFramebuffer(F.READ_FRAMEBUFFER,Gn.__webglFramebuffer),be.bindFramebuffer(F.DRAW_FRAMEBUFFER,Rt.__webglFramebuffer);for(let hn=0;hn<Ie;hn++)Vi&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ze.get(w).__webglTexture,Y,ut+hn),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ze.get(O).__webglTexture,Te,Zt+hn)),F.blitFramebuffer(ke,Qe,ke+Pe,Qe+Ae,Be,ht,Be+Pe,ht+Ae,F.DEPTH_BUFFER_BIT,F.NEAREST);be.bindFramebuffer(F.READ_FRAMEBUFFER,null),be.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(Y!==0||w.isRenderTargetTexture||ze.has(w)){let at=ze.get(w),Qt=ze.get(O);be.bindFramebuffer(F.READ_FRAMEBUFFER,N),be.bindFramebuffer(F.DRAW_FRAMEBUFFER,H);for(let Gn=0;Gn<Ie;Gn++)Vi?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,at.__webglTexture,Y,ut+Gn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,at.__webglTexture,Y),os?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Qt.__webglTexture,Te,Zt+Gn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Qt.__webglTexture,Te),Y!==0?F.blitFramebuffer(ke,Qe,ke+Pe,Qe+Ae,Be,ht,Be+Pe,ht+Ae,F.COLOR_BUFFER_BIT,F.NEAREST):os?F.copyTexSubImage3D(Ue,Te,Be,ht,Zt+Gn,ke,Qe,Pe,Ae):F.copyTexSubImage2D(Ue,Te,Be,ht,ke,Qe,Pe,Ae);be.bindFramebuffer(F.READ_FRAMEBUFFER,null),be.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else os?w.isDataTexture||w.isData3DTexture?F.texSubImage3D(Ue,Te,Be,ht,Zt,Pe,Ae,Ie,Ct,_n,Et.data):O.isCompressedArrayTexture?F.compressedTexSubImage3D(Ue,Te,Be,ht,Zt,Pe,Ae,Ie,Ct,Et.data):F.texSubImage3D(Ue,Te,Be,ht,Zt,Pe,Ae,Ie,Ct,_n,Et):w.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,Te,Be,ht,Pe,Ae,Ct,_n,Et.data):w.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,Te,Be,ht,Et.width,Et.height,Ct,Et.data):F.texSubImage2D(F.TEXTURE_2D,Te,Be,ht,Pe,Ae,Ct,_n,Et);be.pixelStorei(F.UNPACK_ROW_LENGTH,cn),be.pixelStorei(F.UNPACK_IMAGE_HEIGHT,pt),be.pixelStorei(F.UNPACK_SKIP_PIXELS,rs),be.pixelStorei(F.UNPACK_SKIP_ROWS,un),be.pixelStorei(F.UNPACK_SKIP_IMAGES,Nr),Te===0&&O.generateMipmaps===!0&&O.mipmapsAutoUpdate===!0&&F.generateMipmap(Ue),be.unbindTexture()},this.initRenderTarget=function(w){ze.get(w).__webglFramebuffer===void 0&&Xe.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Xe.setTextureCube(w,0):w.isData3DTexture?Xe.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Xe.setTexture2DArray(w,0):Xe.setTexture2D(w,0),be.unbindTexture()},this.resetState=function(){$=0,G=0,le=null,be.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return xi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=mt._getDrawingBufferColorSpace(e),t.unpackColorSpace=mt._getUnpackColorSpace()}};function Hm(){let n={camera:new $n(30,1,.01,100),target:new W,home:null,azimuth:.75,elevation:.4,distance:4.2,changed:!0};return n.home={azimuth:n.azimuth,elevation:n.elevation,distance:n.distance},mr(n),n}function mr(n){let e=n.distance*Math.cos(n.elevation);n.camera.up.set(0,0,1),n.camera.position.set(n.target.x+e*Math.cos(n.azimuth),n.target.y+e*Math.sin(n.azimuth),n.target.z+n.distance*Math.sin(n.elevation)),n.camera.lookAt(n.target),n.camera.updateMatrixWorld(),n.changed=!0}function Wm(n,e,t){n.azimuth-=.006*e,n.elevation=Math.max(-1.5,Math.min(1.5,n.elevation+.006*t)),mr(n)}function uf(n,e){n.distance=Math.max(.3,Math.min(30,n.distance*e)),mr(n)}function hf(n,e,t,i){let{right:s,up:r}=Da(n),o=Cw(n,n.distance,i);n.target.addScaledVector(s,-e*o).addScaledVector(r,t*o),mr(n)}function iu(n){Object.assign(n,n.home),n.target.set(0,0,0),mr(n)}function Da(n){let e=new W,t=new W,i=new W;return n.camera.matrixWorld.extractBasis(e,t,i),{right:e,up:t,forward:i.negate()}}function Cw(n,e,t){return 2*Math.tan(n.camera.fov*Math.PI/360)*e/Math.max(1,t)}function Xm(n,e){let{forward:t}=Da(n);return Math.max(.05,e.clone().sub(n.camera.position).dot(t))}var Rw={pause:"M8 5v14M16 5v14",play:"M8 5l11 7-11 7z",step:"M6 5l8 7-8 7zM18 5v14",reset:"M5 12a7 7 0 1 0 2.3-5.2M5 4v4.5h4.5",record:"M12 12m-5.5 0a5.5 5.5 0 1 0 11 0a5.5 5.5 0 1 0-11 0",stop:"M7 7h10v10H7z",theme:"M12 4a8 8 0 1 0 0 16zM12 4a8 8 0 0 1 0 16",help:"M9 9a3 3 0 1 1 4.2 2.75c-.8.4-1.2 1-1.2 2.25M12 17.5v.5",fit:"M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",levels:"M12 4l8 14H4zM8 11h8M12 4v14",ghost:"M6 20V10a6 6 0 0 1 12 0v10l-3-2-3 2-3-2zM10 10v.5M14 10v.5",contacts:"M4 16h16M8 16v-6M16 16v-6M6 12l2-2.5 2 2.5M14 12l2-2.5 2 2.5",forces:"M5 19L19 5M19 5h-7M19 5v7",open:"M3 18V6h6l2 2.5h10V18z",save:"M12 4v11M7 11l5 5 5-5M5 20h14",hand:"M8 12V6a1.5 1.5 0 0 1 3 0v5V4.5a1.5 1.5 0 0 1 3 0V11V6a1.5 1.5 0 0 1 3 0v8c0 4-2 6-5.5 6S7 18 6 15l-1-2.5c-.5-1.5 1.5-2.3 2.2-1z"};function su(n){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",Rw[n]),e.append(t),e}function Si(n,e,t,i){let s=Object.assign(document.createElement("button"),{type:"button",className:`icon ${n}`});return s.append(su(n)),Mo(s,e,t),s.addEventListener("click",()=>i(s)),s}function Mo(n,e,t){n.title=t?`${e} (${t})`:e,n.setAttribute("aria-label",e)}function Ua(n,e){n.dataset.icon!==e&&(n.dataset.icon=e,n.replaceChildren(su(e)))}var ff=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"],[1e-12,"p"]];function Fa(n,e,t=1e-6){if(n==null||!Number.isFinite(n))return{number:"–",unit:e};let i=Math.abs(n);if(i<.005*t)return{number:"0",unit:e};let[s,r]=ff[ff.length-1];for(let[o,a]of ff)if(i>=.9995*o||o<=t){[s,r]=[o,a];break}return{number:$s(n/s),unit:r+e}}function $s(n){let e=Math.abs(n);return n.toFixed(e<9.995?2:e<99.95?1:0)}function ui(n,e,t){let{number:i,unit:s}=Fa(n,e,t);return i==="–"?i:`${i} ${s}`}function gr(n){if(!Number.isFinite(n))return"–";if(n<60)return`${n.toFixed(1)} s`;let e=Math.floor(n);return`${Math.floor(e/60)}:${String(e%60).padStart(2,"0")} min`}function ti(n,e,t=`${e}s`){return`${n} ${n===1?e:t}`}var Pw={device_lost:"the hand was lost",watchdog:"the haptic loop stood still",not_finite:"a number was not finite",too_fast:"the hand moved too fast",pose_jump:"the hand jumped",turned_too_fast:"the hand turned too fast",orientation_jump:"the hand's direction jumped",contact_stale:"the contact model was too old"},Iw={grasped:"The hand took hold of the object",released:"The hand let the object go",armed:"Forces are on",disarmed:"Forces are off",late:"Late",recording_ended:"The recording has ended",not_armed:"Forces stay off",resumed:"Goes on",parameter:"Parameter changed",fault:"Fault",held_back:"Held back",squeezed:"Squeezed"},df={fault:"ended by a fault",duration:"reached its duration",device_finished:"the hand has finished",stopped:"was stopped"},Lw={hand:"simulated hand",web:"mouse or touch",script:"scripted hand",replay:"recorded hand",null:"no hand","":"a recording"};function qm(n){return Lw[String(n).split(":")[0]]??n}function _r(n){return Pw[n]??String(n).replaceAll("_"," ")}function ru({reason:n,fault:e}){let t=df[n];return!t||n!=="fault"||!e?t:`${t}: ${_r(e.name)}${e.text?` (${e.text})`:""}`}function $m(n,e){return!n||!(e-n.time<6)?null:`The computer was late (${n.count===1?"once":`${n.count} times so far`}): ${n.text??_r(n.name)}.`}function ou({kind:n,detail:e,text:t}){let i=Iw[n]??String(n).replaceAll("_"," "),r=[n==="fault"||n==="late"?_r(e):n==="held_back"?"":e,t].filter(Boolean).join("; ");return r?`${i}: ${r}`:i}function Ym(n){let{object:e,statics:t,grasped:i,contacts:s,clusters:r}=n,o=`The ${e}`;if(s===0)return`${o} ${i?"is in the hand and":"rests and"} touches nothing.`;let a=t.length===1?`the ${t[0]}`:"the scene",l=s===1?"1 contact":`${s} contacts`,c=r===1?"1 cluster":`${r} clusters`;return n.touching&&n.armed===!1?`${o} touches ${a} at ${l} in ${c}; forces are off.`:n.touching?`${o} presses on ${a} at ${l} in ${c}.`:`${o} is close to ${a}: ${l} in ${c}.`}function Zm(n){let{object:e,statics:t,rows:i,pressing:s}=n,r=t.length===1?`the ${t[0]}`:"the scene";if(i===0)return`The ${e} ${n.grasped?"is in the hand and":"rests and"} touches nothing.`;if(s===0)return`The ${e} is close to ${r}: ${i===1?"1 row":`${i} rows`} near, none presses.`;let o=`The ${e} rests on ${s===1?"1 row":`${s} rows`} of ${r}`;return n.armed===!1?`${o}; forces are off.`:`${o}; the hand pulls ${n.newtons}${n.stiffness?`; coupling ${n.stiffness}`:""}.`}function Jm({pressing:n,stiffness:e,stretch:t,force:i,heldBack:s,squeezed:r,say:o}){if(r>.1)return"Squeezed: surfaces all around are nearer than the gap that is kept; move it back the way it came.";if(s>.01)return`Held back in ${Math.round(100*s)} % of the last second: the object waits where its contact model ends; move it more slowly.`;if(!(n>0)||!(e>0))return"Nothing limits the object but the coupling.";let a=e*t,l=`${o(e,"N/m")} × ${o(t,"m")}`;return i<.9*a?`The coupling alone limits the force: ${l} would be ${o(a,"N")}; it has levelled off, or the device is at its limit.`:`The coupling alone limits the force: ${l}. The surfaces do not give.`}function Km(n){return n.filter(({presses:e,friction:t,force:i,normal:s})=>{let r=i.reduce((a,l,c)=>a+l*s[c],0),o=Math.hypot(...i.map((a,l)=>a-r*s[l]));return e&&t>0&&o>.98*t*Math.abs(r)}).length}var Nw=["what a hand feels","speed","what the eye sees","the cap on deviation","the budget"];function jm(n){return Nw.map((i,s)=>[i,n.filter(r=>r.decidedBy===s).length]).filter(([,i])=>i>0).sort(([,i],[,s])=>s-i).map(([i,s])=>`${Math.round(100*s/n.length)} % by ${i}`).join(", ")}function pf(n){let e=new Map;for(let{objectLevel:t}of n)e.set(t,(e.get(t)??0)+1);return[...e].sort(([t],[i])=>t-i)}function Qm(n){let e=document.getElementById("controls"),t=document.getElementById("view-tools"),i={title:document.getElementById("title"),chip:document.getElementById("state"),open:Si("open","Open a scene or a mesh","O",n.open),pause:Si("pause","Pause","P",n.pause),step:Si("step","One step",".",n.step),reset:Si("reset","Begin again","R",n.reset),record:Si("record","Record","",n.record),theme:Si("theme","Light or dark","",n.theme),help:Si("help","Help","?",n.help),device:document.createElement("select"),views:{},act:n};i.device.title="Who moves the object",i.device.setAttribute("aria-label",i.device.title),i.device.addEventListener("change",()=>n.device(i.device.value));let s=(...o)=>{let a=Object.assign(document.createElement("span"),{className:"group"});return a.append(...o),a};e.append(s(i.open),s(i.device),s(i.pause,i.step,i.reset,i.record),s(i.theme,i.help));let r=[["levels","Levels of detail: finest as wireframe","L","wireframe"],["ghost","Ghost of the hand","G","ghost"],["contacts","Contacts and clusters","C","contacts"],["forces","Force and torque","A","forces"]];for(let[o,a,l,c]of r)i.views[c]=Si(o,a,l,()=>n.view(c)),t.append(i.views[c]);return t.append(Si("fit","Fit the view","F",n.fit)),i}function mf(n,e){for(let[t,i]of Object.entries(n.views))i.setAttribute("aria-pressed",String(e[t]))}function eg(n,e){let{state:t,scene:i,snapshot:s,connected:r}=e;n.title.textContent=i?.title??"",document.title=i?`${i.title} · Thigma`:"Thigma";let o=r?t?.run??"connecting":"lost",a=s?` · ${gr(s.time)}`:"",l={lost:"connection lost",connecting:"connecting",running:`running${a}`,paused:`paused${a}`,ended:e.progress?"preparing":df[t?.reason]??"ended"};t?.late&&(l.running+=` · late ${t.late.count}×`);let c=o==="running"&&(s?.bits&4)!==0;t?.replay&&o==="running"&&(l.running=`replaying${a}`),n.chip.textContent=c?`forces off: ${_r(e.faultName())}`:l[o],n.chip.title=o==="ended"?ru(t)??"":t?.late?.text??"",n.chip.dataset.run=c?"fault":o;let u=r&&!!t,h=t?.run==="paused";Ua(n.pause,h?"play":"pause"),Mo(n.pause,h?"Go on":"Pause","P"),n.pause.disabled=!u||t.run==="ended",n.step.disabled=!u||!h,n.reset.disabled=n.record.disabled=n.open.disabled=!u;let f=!!t?.recording;Ua(n.record,f?"stop":"record"),n.record.classList.toggle("on",f),Mo(n.record,f?`Stop recording ${t.recording}`:"Record from the start",""),Dw(n,t,u)}function Dw(n,e,t){let i=[...new Set([...e?.devices??[],...e?[e.device]:[]])];n.device.dataset.uris!==i.join(" ")&&(n.device.dataset.uris=i.join(" "),n.device.replaceChildren(...i.map(s=>new Option(qm(s),s)))),n.device.hidden=i.length===0,n.device.disabled=!t||i.length<2,e&&document.activeElement!==n.device&&(n.device.value=e.device)}function tg(n,e){let t=e?`${e.text}|${e.button??""}`:"";if(n.dataset.key===t||(n.dataset.key=t,n.hidden=!e,!e))return;let i=Object.assign(document.createElement("span"),{textContent:e.text});if(n.className=`hint ${e.mood??""}`,n.replaceChildren(...e.icon?[su(e.icon)]:[],i),!e.button)return;let s=Object.assign(document.createElement("button"),{type:"button",textContent:e.button});s.addEventListener("click",e.act),n.append(s)}function ng(){return{step:0,turned:!1,unarmedSince:null,touchedAt:null}}function ig(n,e,t,i){let{state:s,scene:r,snapshot:o}=e;if(!e.connected||!s||!r||!o)return null;let a=r.object.name,l=(o.bits&32)!==0,c=(o.bits&1)!==0,u=(o.bits&2)!==0,h=(o.bits&4)!==0;if(e.progress)return null;let f=e.hello?.may_control===!1;if(s.run==="ended")return{text:`The session ${ru(s)??"has ended"}.`,button:f?void 0:"Begin again",act:i.reset,mood:"stop"};if(e.refusal&&t.now<e.refusal.until)return{text:e.refusal.text,mood:"stop"};if(f)return{text:"This page watches. To do more, open the address with its token, as the program has printed it."};if(s.replay)return{text:`A recording: ${s.replay.file.split("/").pop()}`,button:s.devices.includes("web:")?"Take it yourself":void 0,act:()=>i.device("web:")};if(h){let g=s.device.startsWith("web:");return{text:`Forces are off: ${_r(e.faultName())}.${g?` Take hold of the ${a} again to go on.`:""}`,button:g?void 0:"Begin again",act:i.reset,mood:"stop"}}let p=$m(s.late,o.time);return p?{text:p,mood:"stop"}:s.device.startsWith("web:")?s.holder==="other"?{text:"Another page holds the hand; this one watches."}:Uw(n,{object:a,grasped:c,armed:u,fading:l,snapshot:o,scene:r,...t}):s.devices.includes("web:")?{text:`A ${s.simulated===!1?"device":"simulated hand"} moves the ${a}.`,button:"Take it yourself",act:()=>i.device("web:"),icon:"hand"}:null}function Uw(n,e){let{object:t,grasped:i,armed:s,now:r,newtons:o}=e;return!i||!e.holding?(n.unarmedSince=null,{text:`Drag the blue ${t}.`,icon:"hand"}):(s?n.unarmedSince=null:n.unarmedSince??=r,!s&&r-n.unarmedSince>.6?{text:`Taken hold of inside a contact: lift the ${t} off once, then forces come on.`}:e.fading?{text:"This page is slow: the force fades until it keeps up, and comes back by itself."}:(o>0&&(n.touchedAt??=r),n.touchedAt===null?{text:`Press it against the ${e.scene.statics[0]?.name??"scene"}: Shift-drag or the wheel moves it deeper. The arrow will be the force in your hand.`}:(!n.turned&&e.turned&&(n.turned=!0),!n.turned&&r-n.touchedAt<12?{text:"Ctrl-drag turns it. Space lets go. Right-drag turns the view."}:null)))}var xr={grasped:1,armed:2,fault:4,paused:8,ended:16,fading:32,heldBack:64,squeezed:128,constrained:256};var gf=64;var Oa=16,Fw=48,au=48;var Ba=class extends Error{},Sn=(n,e)=>{if(!n)throw new Ba(e)};function sg(n){Sn(n.byteLength>=Oa,`a message of ${n.byteLength} bytes has no header`);let e=new DataView(n),t=e.getUint8(0),i=e.getUint8(1),s={bits:e.getUint16(2,!0),count:e.getUint32(4,!0),time:e.getFloat64(8,!0)},r={1:Ow,2:kw,3:zw,4:Bw};return Sn(r[t],`message type ${t} is not known`),Sn(i===1,`layout ${i} of message type ${t} is not known`),r[t](n,e,s)}function lu(n,e,t){Sn(n.byteLength===e,`${t} of ${n.byteLength} bytes, ${e} expected`)}function rg(n,e){let t=e;return(i,s)=>{let r=new i(n,t,s);return t+=4*s,r}}function og({positions:n,triangles:e,patchOfTriangle:t},i,s,r){Sn(n.every(Number.isFinite),`${r} with a position that is no number`),Sn(e.every(o=>o<i),`${r} with a triangle of a vertex that is not there`),Sn(t.every(o=>o<s||o===4294967295),`${r} with a triangle of a patch that is not there`)}function Ow(n,e,{count:t}){Sn(n.byteLength>=32,`mesh of ${n.byteLength} bytes, 32 at least`);let[i,s,r,o]=[16,20,24,28].map(c=>e.getUint32(c,!0));lu(n,32+12*i+16*s+4*r+8*o,"mesh");let a=rg(n,32),l={kind:"mesh",number:t,positions:a(Float32Array,3*i),triangles:a(Uint32Array,3*s),patchOfTriangle:a(Uint32Array,s),nodeOfPatch:a(Int32Array,r),parents:a(Int32Array,o),levels:a(Int32Array,o)};return og(l,i,r,"mesh"),Sn(l.nodeOfPatch.every(c=>c>=0&&c<o),"mesh with a patch of a node that is not there"),Sn(l.parents.every(c=>c>=-1&&c<o),"mesh with a parent that is not there"),Sn(l.levels.every(c=>c>=0),"mesh with a negative level"),l}function Bw(n,e,{bits:t,count:i}){Sn(n.byteLength>=32,`level of ${n.byteLength} bytes, 32 at least`);let[s,r,o]=[16,20,24].map(c=>e.getUint32(c,!0));lu(n,32+12*s+16*r+4*o,"level");let a=rg(n,32),l={kind:"level",number:i,level:t,positions:a(Float32Array,3*s),triangles:a(Uint32Array,3*r),patchOfTriangle:a(Uint32Array,r),nodeOfPatch:a(Int32Array,o)};return Sn(t>0,"level 0 comes as a mesh"),og(l,s,o,"level"),Sn(l.nodeOfPatch.every(c=>c>=-1),"level with a patch of no node that could be"),l}function kw(n,e,{bits:t,count:i,time:s}){return Sn(t>0,"channels without a column"),Sn(Number.isFinite(s),"channels without a time"),lu(n,Oa+4*t*i,"channels"),{kind:"channels",columns:t,rows:i,time:s,values:new Float32Array(n,Oa,t*i)}}function zw(n,e,{bits:t,count:i,time:s}){Sn(n.byteLength>=240,`snapshot of ${n.byteLength} bytes, 240 at least`);let r=e.getUint32(216,!0),o=e.getUint32(236,!0);lu(n,240+au*(i+r+o),"snapshot");let a=new Float32Array(n,24,Fw),l=h=>[a[h],a[h+1],a[h+2]],c=h=>({position:l(h),quaternion:[a[h+3],a[h+4],a[h+5],a[h+6]]}),u={kind:"snapshot",time:s,bits:t,frame:e.getFloat64(16,!0),object:c(0),ghost:c(7),handle:c(14),grasp:l(21),force:l(24),torque:l(27),contactForce:l(30),contactTorque:l(33),center:l(36),penetration:a[39],stretch:a[40],energy:a[41],modelAge:a[42],modelWeight:a[43],hapticRate:a[44],contactRate:a[45],queryCpu:a[46],metresPerNewton:a[47],contactsFound:e.getUint32(220,!0),contactsDropped:e.getUint32(224,!0),front:e.getUint32(228,!0),fault:e.getUint32(232,!0),contacts:[],clusters:[],rows:[]};Sn(a.subarray(0,24).every(Number.isFinite),"snapshot with a pose that is no number");for(let h=0;h<i;h++)u.contacts.push(Vw(e,240+au*h));for(let h=0;h<r;h++)u.clusters.push(Gw(e,240+au*(i+h)));for(let h=0;h<o;h++)u.rows.push(Hw(e,240+au*(i+r+h)));return u}var Ys=(n,e,t)=>Array.from({length:t},(i,s)=>n.getFloat32(e+4*s,!0));function Vw(n,e){let t=n.getUint32(e+44,!0);return{point:Ys(n,e,3),normal:Ys(n,e+12,3),depth:n.getFloat32(e+24,!0),bound:n.getFloat32(e+28,!0),body:n.getInt32(e+32,!0),objectNode:n.getInt32(e+36,!0),sceneNode:n.getInt32(e+40,!0),objectLevel:t&255,sceneLevel:t>>8&255,status:t>>16&255,decidedBy:t>>>24}}function Gw(n,e){return{point:Ys(n,e,3),normal:Ys(n,e+12,3),depth:n.getFloat32(e+24,!0),force:Ys(n,e+28,3),id:n.getInt32(e+40,!0)}}function Hw(n,e){let t=n.getUint32(e+44,!0);return{point:Ys(n,e,3),normal:Ys(n,e+12,3),gap:n.getFloat32(e+24,!0),force:Ys(n,e+28,3),friction:n.getFloat32(e+40,!0),kind:t&3,presses:(t&4)!==0}}function ag(n){let e=null;try{e=JSON.parse(n)}catch{}return Sn(e&&typeof e=="object"&&typeof e.type=="string","a text message without a type"),e}function lg(n){let e=new ArrayBuffer(Oa+n.length),t=new DataView(e);return t.setUint8(0,33),t.setUint8(1,1),t.setUint32(4,n.length,!0),new Uint8Array(e,Oa).set(n),e}var Xw=.004,cg=9.9;function ug(){return{position:[0,0,0],quaternion:[0,0,0,1],clutch:!1,pending:[],latest:-1/0}}function _f(n,e){return[n[3]*e[0]+n[0]*e[3]+n[1]*e[2]-n[2]*e[1],n[3]*e[1]-n[0]*e[2]+n[1]*e[3]+n[2]*e[0],n[3]*e[2]+n[0]*e[1]-n[1]*e[0]+n[2]*e[3],n[3]*e[3]-n[0]*e[0]-n[1]*e[1]-n[2]*e[2]]}var xf=n=>[-n[0],-n[1],-n[2],n[3]];function hg(n,e){let[t,i,s]=_f(_f(n,[...e,0]),xf(n));return[t,i,s]}function qw(n,e){let t=Math.sin(.5*e);return[t*n[0],t*n[1],t*n[2],Math.cos(.5*e)]}function fg(n,e,t){let i=hg(xf(t.quat_xyzw),e);n.position=n.position.map((s,r)=>Math.max(-cg,Math.min(cg,s+i[r]/t.motion_scale)))}function cu(n,e,t,i){let s=hg(xf(i.quat_xyzw),e),r=_f(qw(s,t),n.quaternion),o=Math.hypot(...r);n.quaternion=r.map(a=>a/o)}function $w(n,e,t=-1/0){let i=n[n.length-1],s=n[n.length-2]?.time??t;i&&i.buttons===e.buttons&&i.time-s<Xw?n[n.length-1]=e:n.push(e),n.length>gf&&n.splice(0,n.length-gf)}var vf=n=>({position:[...n.position],quaternion:[...n.quaternion]});function bo(n,e,t=vf(n)){let i={time:Math.max(e,n.latest),...t,buttons:n.clutch?1:0};$w(n.pending,i,n.sent),n.latest=i.time}function yf(n){let e=n.pending;return n.pending=[],e.length>0&&(n.sent=e[e.length-1].time),e}function dg(n,e,t,i=.7){let s=e.length/3,r=n.length/3,o=new Float64Array(e.length),a=new Float64Array(e.length);for(let d=0;d<s;d++)Yw(n,e,d,o,a);let l=new Uint32Array(r+1);for(let d of e)l[d+1]++;for(let d=0;d<r;d++)l[d+1]+=l[d];let c=new Uint32Array(e.length),u=l.slice();for(let d=0;d<e.length;d++)c[u[e[d]]++]=d;let h=[],f=[],p=[],g=new Uint32Array(e.length),S=Math.cos(i);for(let d=0;d<r;d++){let m=c.subarray(l[d],l[d+1]),y=new Map;for(let C of m){let b=3*Math.floor(C/3),P=0,A=0,x=0,T=0;for(let I=0;I<m.length;I++){let k=3*Math.floor(m[I]/3),V=a[b]*a[k]+a[b+1]*a[k+1]+a[b+2]*a[k+2];k!==b&&!(V>S)&&m.length<=31||(T|=1<<(I&31),P+=o[k],A+=o[k+1],x+=o[k+2])}let B=t[Math.floor(C/3)],D=B*2**32+(T>>>0);if(!y.has(D)){y.set(D,h.length/3),p.push(B),h.push(n[3*d],n[3*d+1],n[3*d+2]);let I=Math.hypot(P,A,x)||1;f.push(P/I,A/I,x/I)}g[C]=y.get(D)}}return{positions:Float32Array.from(h),normals:Float32Array.from(f),labels:Float32Array.from(p),index:g}}function Yw(n,e,t,i,s){let r=3*e[3*t],o=3*e[3*t+1],a=3*e[3*t+2],l=n[o]-n[r],c=n[o+1]-n[r+1],u=n[o+2]-n[r+2],h=n[a]-n[r],f=n[a+1]-n[r+1],p=n[a+2]-n[r+2],g=[c*p-u*f,u*h-l*p,l*f-c*h],S=Math.hypot(g[0],g[1],g[2]);for(let d=0;d<3;d++)i[3*t+d]=g[d],s[3*t+d]=S>0?g[d]/S:0}function pg(n){let e=new Float64Array(n.length),t=n.reduce((s,r)=>Math.max(s,r),0)+1;for(let s=0;s<n.length;s++){let r=n[s],o=n[s%3===2?s-2:s+1];e[s]=Math.min(r,o)*t+Math.max(r,o)}e.sort();let i=[];for(let s=0;s<e.length;s++)s>0&&e[s]===e[s-1]||i.push(Math.floor(e[s]/t),e[s]%t);return Uint32Array.from(i)}function Sf(n){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let s=0;s<n.length;s++){let r=s%3;n[s]<e[r]&&(e[r]=n[s]),n[s]>t[r]&&(t[r]=n[s])}let i=e.map((s,r)=>.5*(s+t[r]));return{min:e,max:t,center:i,radius:.5*Math.hypot(...e.map((s,r)=>t[r]-s))}}var mg="thigma-theme";function uu(){let n=document.documentElement.dataset.theme;return n||(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light")}function gg(n){let e=null;try{e=localStorage.getItem(mg)}catch{}return(e==="light"||e==="dark")&&(document.documentElement.dataset.theme=e),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>n()),function(){let i=uu()==="dark"?"light":"dark";document.documentElement.dataset.theme=i;try{localStorage.setItem(mg,i)}catch{}n()}}function Bt(n){return getComputedStyle(document.documentElement).getPropertyValue(`--${n}`).trim()}var Ms=["#0a8f83","#23ab6a","#7cc542","#bdd334","#e6d32e","#f5a32b","#ea7430","#d64a45"];function vr(n){return Ms[Math.max(0,Math.min(Ms.length-1,n))]}var bf=512,vg=16,Va=new W(0,0,1);function Zs(n={}){return new lr({roughness:.5,metalness:0,...n})}function yr(n={}){return new ks({transparent:!0,opacity:.42,depthTest:!1,depthWrite:!1,...n})}function yg(){let n=new xn,e=new Li(.5,.5,1,20).rotateX(Math.PI/2).translate(0,0,.5),t=new xs(1.35,3.6,28).rotateX(Math.PI/2).translate(0,0,1.8),i=[];for(let s of[Zs(),yr()]){let r=new Wt(e,s),o=new Wt(t,s);r.renderOrder=o.renderOrder=s.depthTest?0:20,i.push({shaft:r,head:o,material:s}),n.add(r,o)}return n.visible=!1,{group:n,parts:i}}function Sg(n,e,t,i){let s=t.length();if(n.group.visible=s>.2*i,!n.group.visible)return;n.group.position.copy(e),n.group.quaternion.setFromUnitVectors(Va,t.clone().divideScalar(s));let r=Math.min(i,s/3.6);for(let{shaft:o,head:a}of n.parts)o.scale.set(r,r,Math.max(1e-6*i,s-3.4*r)),a.scale.setScalar(r),a.position.set(0,0,s-3.6*r)}function Mg(n,e){for(let{material:t}of n.parts)t.color.set(e)}var ka=72,bs=10,_g=.055;function bg(){let n=new xn,e=Zw(),t=new xs(.15,.38,24),i=[];for(let s of[Zs(),yr()]){let r=new Wt(e,s),o=new Wt(t,s);r.renderOrder=o.renderOrder=s.depthTest?0:20,i.push({ring:r,head:o,material:s}),n.add(r,o)}return n.visible=!1,{group:n,parts:i,ring:e}}function Zw(){let n=[],e=[],t=[];for(let s=0;s<=ka;s++){let r=2*Math.PI*s/ka;for(let o=0;o<bs;o++){let a=2*Math.PI*o/bs,l=Math.cos(a),c=Math.sin(a);e.push(l*Math.cos(r),l*Math.sin(r),c);let u=1+_g*l;n.push(u*Math.cos(r),u*Math.sin(r),_g*c);let h=(o+1)%bs;if(s<ka){let f=s*bs+o,p=s*bs+h;t.push(f,p,f+bs,p,p+bs,f+bs)}}}let i=new Dn;return i.setAttribute("position",new on(Float32Array.from(n),3)),i.setAttribute("normal",new on(Float32Array.from(e),3)),i.setIndex(t),i}function wg(n,e,t,i,s){if(n.group.visible=i>.01&&t.lengthSq()>0,!n.group.visible)return;n.group.position.copy(e),n.group.quaternion.setFromUnitVectors(Va,t.clone().normalize()),n.group.scale.setScalar(s);let r=Math.max(1,Math.round(300/360*ka*Math.min(1,i)));n.ring.setDrawRange(0,r*bs*6);let o=2*Math.PI*r/ka;for(let{head:a}of n.parts)a.position.set(Math.cos(o),Math.sin(o),0),a.rotation.set(0,0,o),a.scale.setScalar(Math.min(1,.25+4*i))}function Tg(n,e){for(let{material:t}of n.parts)t.color.set(e)}function hu(n,e,t,i,s){let r=new la(e,t,i);return r.frustumCulled=!1,r.renderOrder=s,r.count=0,r.setColorAt(0,new je),n.add(r),r}function Ag(){let n=new xn,e=new Vs(1,12,8),t=new Li(.22,.22,1,8).rotateX(Math.PI/2).translate(0,0,.5),i=new da(1,.12,8,40),s=(...o)=>hu(n,...o),r={group:n,dots:[],needles:[],rings:[]};for(let[o,a]of[[Zs(),1],[yr({opacity:.45}),21]])r.dots.push(s(e,o,bf,a)),r.needles.push(s(t,o,bf,a));for(let[o,a]of[[Zs(),1],[yr({opacity:.55}),22]])r.rings.push(s(i,o,vg,a));return r}var xg=new vt,wf=new Ln,Tf=new W,Af=new W,Ef=new je;function Cf(n,e,t,i,s){let r=Math.min(bf,e.length);for(let a=0;a<r;a++){let{point:l,normal:c,level:u}=e[a];Tf.set(...l),wf.setFromUnitVectors(Va,Af.set(...c).normalize()),Ef.set(vr(u)),Mf(n.dots,a,i,i),Mf(n.needles,a,i,5.5*i)}za(n.dots,r),za(n.needles,r);let o=Math.min(vg,t.length);for(let a=0;a<o;a++){Tf.set(...t[a].point),wf.setFromUnitVectors(Va,Af.set(...t[a].normal).normalize()),Ef.set(s);let l=i*(2.6+2.4*Math.sqrt(Math.max(0,Math.min(1,t[a].share))));Mf(n.rings,a,l,l)}za(n.rings,o)}function Mf(n,e,t,i){xg.compose(Tf,wf,Af.set(t,t,i));for(let s of n)s.setMatrixAt(e,xg),s.setColorAt(e,Ef)}function za(n,e){for(let t of n)t.count=e,t.instanceMatrix.needsUpdate=!0,t.instanceColor&&(t.instanceColor.needsUpdate=!0)}function Eg(){let n=Zs(),e=yr({opacity:.5}),t=new xn,i=new Li(1,1,1,10).rotateX(Math.PI/2).translate(0,0,.5),s=new Vs(1,16,12),r=[],o=[];for(let a of[n,e]){let l=new Wt(i,a),c=new Wt(s,a);l.renderOrder=c.renderOrder=a.depthTest?0:23,r.push(l),o.push(c),t.add(l,c)}return{group:t,rods:r,knobs:o,materials:[n,e]}}function Cg(n,e,t,i){let s=t.clone().sub(e),r=s.length();n.group.position.copy(e),r>0&&n.group.quaternion.setFromUnitVectors(Va,s.divideScalar(r));for(let o of n.rods)o.scale.set(i,i,Math.max(r,1e-9*i));for(let o of n.knobs)o.position.set(0,0,r),o.scale.setScalar(2.6*i)}function Rg(n,e){for(let t of n.materials)t.color.set(e)}var Pf=64,Rf=new W(0,0,1);function Lg(){let n=new xn,e={planes:new Li(1,1,.06,28).rotateX(Math.PI/2),points:new Vs(.36,12,8),forces:new Li(.16,.16,1,8).rotateX(Math.PI/2).translate(0,0,.5),heads:new xs(.42,1,16).rotateX(Math.PI/2).translate(0,0,.5),cones:new xs(1,1,28,1,!0).translate(0,-.5,0).rotateX(-Math.PI/2)},t={group:n};for(let[i,s]of Object.entries(e)){let r=i==="cones"||i==="planes",o=r?Zs({transparent:!0,opacity:i==="cones"?.34:.72,depthWrite:!1,side:2}):Zs(),a=yr({opacity:r?.16:.5,side:r?2:0});t[i]=[hu(n,s,o,Pf,r?3:2),hu(n,s,a,Pf,22)]}return t}var Pg=new vt,fu=new Ln,Ga=new W,du=new W,Jw=new W,Ig=new je;function If(n,e,{size:t,longest:i},s){let r=e.slice(0,Pf),o=Math.max(1e-30,...r.map(({force:c})=>Math.hypot(...c))),a={planes:0,points:0,forces:0,heads:0,cones:0},l=(c,u,h)=>{Pg.compose(Ga,fu,Jw.set(u,u,h));for(let f of n[c])f.setMatrixAt(a[c],Pg),f.setColorAt(a[c],Ig);a[c]+=1};for(let{point:c,normal:u,gap:h,force:f,friction:p,kind:g,presses:S}of r){Ig.set(S?s.press:s.near);let d=c.map((P,A)=>P+h*u[A]),m=S?t:.62*t;if(fu.setFromUnitVectors(Rf,du.set(...u).normalize()),Ga.set(...g===1?d:c),l("points",m,m),Ga.set(...g===1?c:d),l(g===2?"points":"planes",m,m),!S)continue;Ga.set(...c),p>0&&(fu.setFromUnitVectors(Rf,du.set(...u).multiplyScalar(-1).normalize()),l("cones",.8*i*p,.8*i));let y=Math.hypot(...f);if(!(y>0))continue;fu.setFromUnitVectors(Rf,du.set(...f).divideScalar(y));let C=i*(.25+.75*y/o),b=Math.min(1.1*t,.5*C);l("forces",t,C-b),Ga.addScaledVector(du,C-b),l("heads",t,b)}for(let[c,u]of Object.entries(a))za(n[c],u)}function Ng(n,e){let t=e.length,i=new Uint32Array(t);for(let f of n)i[f]++;let s=jw(e),r=i.slice();for(let f=t-1;f>=0;f--){let p=s[f];e[p]>=0&&(r[e[p]]+=r[p])}let o=new Uint32Array(t),a=new Uint32Array(t),l=new Uint32Array(t),c=0;for(let f of s){let p=e[f];o[f]=p<0?c:l[p],a[f]=o[f]+r[f],p<0?c=a[f]:l[p]=a[f],l[f]=o[f]+i[f]}let u=new Uint32Array(n.length),h=o.slice();for(let f=0;f<n.length;f++)u[h[n[f]]++]=f;return{order:u,begin:o,end:a}}function jw(n){let e=n.map(()=>0);for(let r of n)r>=0&&e[r]++;let t=new Uint32Array(n.length),i=n.length,s=[];for(let r=0;r<n.length;r++)e[r]===0&&s.push(r);for(;s.length>0;){let r=s.pop();t[--i]=r,n[r]>=0&&--e[n[r]]===0&&s.push(n[r])}if(i!==0)throw new RangeError("the hierarchy runs in a circle");return t}function Dg(n,e,t){t.fill(0);for(let{node:i,level:s}of e)if(!(i<0||i>=n.begin.length))for(let r=n.begin[i];r<n.end[i];r++){let o=n.order[r];(t[o]===0||t[o]>s+1)&&(t[o]=Math.min(255,s+1))}}var Ug=(n,e)=>n.patchOfTriangle[e]===4294967295?-1:n.patchOfTriangle[e];function Fg(n,e,t,i){return Int32Array.from(n,s=>{let r=s;for(;e[r]>=0&&t[e[r]]<=i;)r=e[r];return r})}function Og(n,e,t){let i=new Map(e.map(({node:s,level:r})=>[s,r]));for(let s=0;s<n.length;s++){let r=i.get(n[s]);t[s]=r===void 0||n[s]<0?0:Math.min(255,r+1)}}function Bg(n){let e=n*.61803398875%1,t=[.62,.5,.72][n%3],i=.55,s=r=>{let o=(r+e*12)%12;return Math.round(255*(t-i*Math.min(t,1-t)*Math.max(-1,Math.min(o-3,9-o,1))))};return[s(0),s(8),s(4)]}var Ha=24,ws=1024;function Qw(n){return{patchLevels:{value:n},spotCount:{value:0},spotRadius:{value:1},spots:{value:Array.from({length:Ha},()=>new Ot)},levelColours:{value:Ms.map((e,t)=>new je(vr(t)))},onlyActive:{value:0},patchTints:{value:null},tinted:{value:0}}}function e1(n){let e=new lr({roughness:.62,metalness:0});return e.onBeforeCompile=t=>{Object.assign(t.uniforms,n),t.vertexShader=t.vertexShader.replace("#include <common>",`#include <common>
attribute float patchNumber;
varying vec3 meshPoint;
flat varying float onPatch;`).replace("#include <begin_vertex>",`#include <begin_vertex>
meshPoint = position;
onPatch = patchNumber;`),t.fragmentShader=t.fragmentShader.replace("#include <common>",`#include <common>
varying vec3 meshPoint;
flat varying float onPatch;
uniform sampler2D patchLevels;
uniform int spotCount;
uniform float spotRadius;
uniform float onlyActive;
uniform sampler2D patchTints;
uniform float tinted;
uniform vec4 spots[${Ha}];
uniform vec3 levelColours[${Ms.length}];`).replace("#include <color_fragment>",`#include <color_fragment>
{
  float nearest = 1.0;
  int level = 0;
  for (int k = 0; k < ${Ha}; k++) {
    if (k >= spotCount) break;
    float d = distance(meshPoint, spots[k].xyz) / spotRadius;
    if (d < nearest) { nearest = d; level = int(spots[k].w); }
  }
  float share = 0.5 * (1.0 - smoothstep(0.35, 1.0, nearest));
  int patchIndex = int(onPatch + 0.5);
  if (onPatch >= 0.0) {
    float stored = texelFetch(patchLevels, ivec2(patchIndex % ${ws}, patchIndex / ${ws}), 0).r;
    int levelPlusOne = int(stored * 255.0 + 0.5);
    if (levelPlusOne > 0) { share = 0.92; level = levelPlusOne - 1; }
  }
  if (onlyActive > 0.5 && share < 0.02) discard;
  level = min(level, ${Ms.length-1});
  diffuseColor.rgb = mix(diffuseColor.rgb, levelColours[level], share);
  if (tinted > 0.5 && onPatch >= 0.0) {
    vec3 own = texelFetch(patchTints, ivec2(patchIndex % ${ws}, patchIndex / ${ws}), 0).rgb;
    diffuseColor.rgb = mix(own, levelColours[level], 0.75 * step(0.9, share));
  }
}`)},e}function Lf(n){let e=n.triangles.length/3,t=Float32Array.from({length:e},(p,g)=>Ug(n,g)),i=dg(n.positions,n.triangles,t),s=new Dn;s.setAttribute("position",new on(i.positions,3)),s.setAttribute("normal",new on(i.normals,3)),s.setAttribute("patchNumber",new on(i.labels,1)),s.setIndex(new on(i.index,1));let r=new Dn;r.setAttribute("position",new on(n.positions,3)),r.setIndex(new on(pg(n.triangles),1));let o=new Uint8Array(ws*kg(n)),a=zg(o,vo),l=Qw(a),c=new Wt(s,e1(l));c.castShadow=c.receiveShadow=!0;let u=new ca(r,new co({transparent:!0,opacity:.16}));u.visible=!1;let h=new xn;h.add(c,u);let f=n.parents?Ng(n.nodeOfPatch,n.parents):null;return{group:h,solid:c,lines:u,uniforms:l,geometry:s,mesh:n,ranges:f,bytes:o,patchLevels:a}}var kg=n=>Math.max(1,Math.ceil(n.nodeOfPatch.length/ws));function zg(n,e){let t=new or(n,ws,n.length/(ws*(e===ei?4:1)),e,kn);return t.unpackAlignment=1,t.needsUpdate=!0,t}function Vg(n,e){let{uniforms:t,mesh:i}=n;if(t.tinted.value=e===null?0:1,e===null||n.tintedAt===e)return;let s=i.parents?Fg(i.nodeOfPatch,i.parents,i.levels,e):i.nodeOfPatch,r=new Uint8Array(4*ws*kg(i));s.forEach((o,a)=>r.set([...Bg(Math.max(0,o)),255],4*a)),t.patchTints.value?.dispose(),t.patchTints.value=zg(r,ei),n.tintedAt=e}function Nf(n,e,t){n.solid.material.color.set(e),n.lines.material.color.set(t)}function Gg(n,e,t){n.solid.visible=e!=="none",n.uniforms.onlyActive.value=e==="active"?1:0,n.lines.visible=t>0,n.lines.material.opacity=t}function Hg(n,e){n.ranges?Dg(n.ranges,e,n.bytes):Og(n.mesh.nodeOfPatch,e,n.bytes),n.patchLevels.needsUpdate=!0}function Wg(n,e,t){let{uniforms:i}=n;i.spotCount.value=Math.min(Ha,e.length),i.spotRadius.value=t;for(let s=0;s<i.spotCount.value;s++)i.spots.value[s].set(...e[s].point,e[s].level)}function Xg(n,e,t=Ha){let i=[];for(let s of n){if(i.length===t)break;i.some(o=>o.level===s.level&&t1(o.point,s.point)<e)||i.push(s)}return i}var t1=(n,e)=>Math.hypot(n[0]-e[0],n[1]-e[1],n[2]-e[2]);function qg(n){n.geometry.dispose(),n.patchLevels.dispose(),n.uniforms.patchTints.value?.dispose(),n.lines.geometry.dispose(),n.solid.material.dispose(),n.lines.material.dispose()}function Df(n,e){let t=Lf(n);return{group:t.group,geometry:t.geometry,finest:t,about:e,levels:new Map,browsed:null,wireframe:!1,colours:null}}function $g(n,e){return e>0&&!n.levels.has(e)&&Uf(n,e)}function Uf({about:n},e){let t=n.level_list?.[e];return!!t&&!t.free&&t.triangles>0}function Yg(n,e){if(n.levels.has(e.level))return;let t=Lf(e);n.levels.set(e.level,t),n.group.add(t.group),n.colours&&Nf(t,...n.colours),Zg(n)}function Ff(n,e,t){n.colours=[e,t];for(let i of pu(n))Nf(i,e,t)}var pu=n=>[n.finest,...n.levels.values()];function mu(n,{wireframe:e=n.wireframe,browsed:t=n.browsed}){Object.assign(n,{wireframe:e,browsed:t}),Zg(n)}function Zg(n){let{browsed:e,wireframe:t}=n,i=e===null?t?null:n.finest:n.levels.get(e)??n.finest;for(let s of pu(n)){let r=e!==null&&s===i;Vg(s,r?e:null),Gg(s,s===i?"whole":i===null?"active":"none",r?.3:t&&e===null&&s===n.finest?.16:0)}}function Jg(n,e,t){let i=.03*t,s=.075*t,r=a=>n.levels.get(a),o=!n.wireframe||n.browsed!==null;for(let a of pu(n)){let l=e.filter(({level:c})=>a===n.finest?o||!r(c):a===r(c));Hg(a,l),Wg(a,Xg(l,i),s)}}function Kg(n){for(let e of pu(n))qg(e)}var Of=[{ratio:1,shadows:!0},{ratio:.7,shadows:!0},{ratio:.5,shadows:!1},{ratio:.35,shadows:!1}],n1=.1,e0=.04,jg=2,i1=3,s1=60;function t0({step:n=0,fixed:e=!1}={}){return{step:n,fixed:e,seen:0,mean:0,patience:s1,climbed:!1}}function n0(n,e){if(n.seen+=1,n.fixed||n.seen<=jg)return!1;let t=n.seen-jg;return n.mean+=(e-n.mean)/Math.min(t,8),t>=i1&&n.mean>n1&&n.step<Of.length-1?(n.climbed&&(n.patience*=4),Qg(n,1),!0):t>=n.patience&&n.mean<e0&&n.step>0?(Qg(n,-1),!0):!1}function Qg(n,e){Object.assign(n,{step:n.step+e,seen:0,mean:0,climbed:e<0})}var i0=(n,e)=>e||n>e0?n:0;var r1=2,o1=1.6;function a1(){let n=document.createElement("canvas").getContext("webgl2"),e=n?.getExtension("WEBGL_debug_renderer_info"),t=e?n.getParameter(e.UNMASKED_RENDERER_WEBGL):"";return n?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t)}function s0(n,e=null){let t=e==="plain"||e!=="full"&&a1(),i=new eu({canvas:n,antialias:!t,alpha:!0,powerPreference:"high-performance"});i.outputColorSpace=qn,i.toneMapping=Sa,i.shadowMap.enabled=!0,i.shadowMap.type=cr,i.shadowMap.autoUpdate=!1;let s=new sa,r=new xn;s.add(r);let o={canvas:n,renderer:i,scene:s,root:r,view:Hm(),plain:t,lights:l1(s,t),ground:c1(s),radius:1,size:1,object:null,statics:[],ghost:null,force:yg(),twist:bg(),marks:Ag(),rows:Lg(),spring:Eg(),dirty:!0,options:{wireframe:!1,ghost:!0,contacts:!0,forces:!0},wants:()=>{},wanted:new Set,last:null,moved:!0,resized:!0,fence:null,begun:0,rested:0,pace:t0({step:t?r1:0,fixed:e==="full"})};return r.add(o.force.group,o.twist.group,o.marks.group,o.rows.group,o.spring.group),o.spring.group.visible=!1,o}function l1(n,e){let t=new ga(16777215,9077624,1.5);t.position.set(0,0,1);let i=new fo(16774372,2.6);i.position.set(2.3,-1.5,3.6),i.castShadow=!0,i.shadow.mapSize.setScalar(e?768:1536),Object.assign(i.shadow.camera,{left:-1.5,right:1.5,top:1.5,bottom:-1.5,near:.5,far:9}),i.shadow.radius=4,i.shadow.bias=-6e-4,i.shadow.normalBias=.006;let s=new fo(13624319,.9);s.position.set(-2.2,2.2,1.2);let r=new va(16777215,.18);return n.add(t,i,s,r),{sky:t,key:i,rim:s,fill:r}}function c1(n){let e=new Wt(new ar(12,12),new pa({opacity:.2}));return e.receiveShadow=!0,e.renderOrder=-1,n.add(e),e}function r0(n,e,t){for(let i of Sr(n))n.root.remove(i.group),Kg(i);n.ghost&&n.root.remove(n.ghost.group),n.last=null;for(let{group:i}of[n.force,n.twist,n.spring])i.visible=!1;Cf(n.marks,[],[],1,Bt("ring")),If(n.rows,[],{size:1,longest:1},{near:Bt("contact"),press:Bt("press")}),n.object=Df(t.get(e.object.mesh),e.object),n.statics=e.statics.map(i=>{let s=Df(t.get(i.mesh),i);return gu(s.group,{position:i.position,quaternion:i.quat_xyzw}),s});for(let i of Sr(n))mu(i,{wireframe:n.options.wireframe});n.ghost=u1(n.object),gu(n.object.group,{position:e.start.position,quaternion:e.start.quat_xyzw}),n.root.add(n.object.group,...n.statics.map(i=>i.group),n.ghost.group),n.size=e.object.radius,n.wanted.clear(),h1(n),n.moved=!0,_u(n)}var Sr=n=>n.object?[n.object,...n.statics]:[];function o0(n,e){for(let t of Sr(n))t.about.mesh===e.number&&Yg(t,e);n.last&&kf(n,n.last),n.dirty=n.moved=!0}function a0(n,e,t){mu(e,{browsed:t}),t!==null&&l0(n,e,t),n.last&&kf(n,n.last),n.dirty=n.moved=!0}function l0(n,e,t){let i=`${e.about.mesh} ${t}`;!$g(e,t)||n.wanted.has(i)||(n.wanted.add(i),n.wants(e.about.mesh,t))}function u1(n){let e=new xn,t=new Wt(n.geometry,new ks({colorWrite:!1,transparent:!0}));t.onBeforeRender=s=>s.clearDepth();let i=new Wt(n.geometry,new vi({transparent:!0,depthWrite:!1,uniforms:{tone:{value:new je}},vertexShader:`varying vec3 facing; varying vec3 toEye;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  facing = normalize(normalMatrix * normal);
  toEye = -seen.xyz;
  gl_Position = projectionMatrix * seen;
}`,fragmentShader:`varying vec3 facing; varying vec3 toEye; uniform vec3 tone;
void main() {
  float rim = 1.0 - abs(dot(normalize(facing), normalize(toEye)));
  gl_FragColor = vec4(tone, 0.10 + 0.55 * rim * rim * rim);
  #include <colorspace_fragment>
}`}));return t.renderOrder=10,i.renderOrder=11,e.add(t,i),e.visible=!1,{group:e,glass:i}}function gu(n,e){n.position.fromArray(e.position),n.quaternion.fromArray(e.quaternion)}function h1(n){let e=[];for(let{group:i,geometry:s}of[n.object,...n.statics]){let r=Sf(s.attributes.position.array);i.updateMatrix();for(let o=0;o<8;o++){let a=[0,1,2].map(l=>o&1<<l?r.max[l]:r.min[l]);e.push(...new W(...a).applyMatrix4(i.matrix).toArray())}}let t=Sf(e);n.radius=t.radius>0?t.radius:1,n.root.scale.setScalar(1/n.radius),n.root.position.fromArray(t.center).multiplyScalar(-1/n.radius),n.ground.position.z=(t.min[2]-t.center[2])/n.radius-.012,n.root.updateMatrixWorld()}function _u(n){if(n.object){Ff(n.object,Bt("held"),Bt("held-line"));for(let e of n.statics)Ff(e,Bt("fixed"),Bt("fixed-line"));n.ghost.glass.material.uniforms.tone.value.set(Bt("ghost"))}Mg(n.force,Bt("force")),Tg(n.twist,Bt("torque")),Rg(n.spring,Bt("hand")),n.ground.material.opacity=Number(Bt("shadow")),n.lights.sky.intensity=Number(Bt("sky")),n.dirty=!0}function Bf(n,e){if(!n.object)return;n.last=e,gu(n.object.group,e.object),gu(n.ghost.group,e.ghost);let t=(e.bits&1)!==0,i=new W(...e.grasp),s=new W(...e.handle.position);n.ghost.group.visible=n.options.ghost&&t&&f1(e,n.size)>.004,n.spring.group.visible=n.options.ghost&&t,Cg(n.spring,i,s,.012*n.size),d1(n,e,i),kf(n,e),n.dirty=n.moved=!0}function f1({object:n,ghost:e},t){let i=Math.hypot(...n.position.map((o,a)=>o-e.position[a])),s=new Ln(...n.quaternion),r=new Ln(...e.quaternion);return i/t+s.angleTo(r)}function d1(n,e,t){if(!n.options.forces){n.force.group.visible=n.twist.group.visible=!1;return}let i=e.metresPerNewton>0?e.metresPerNewton:.5*n.size,s=new W(...e.force).multiplyScalar(o1*i);s.clampLength(0,4*n.size),Sg(n.force,t,s,.045*n.size);let r=new W(...e.torque),o=.5*n.size*n.size/i;wg(n.twist,t,r,r.length()/o,.42*n.size)}function kf(n,e){let t=(e.bits&xr.constrained)!==0,i=n.options.contacts&&!t?e.contacts:[];If(n.rows,n.options.contacts?e.rows:[],{size:.045*n.size,longest:.34*n.size},{near:Bt("contact"),press:Bt("press")});let s=Math.max(1e-30,...e.clusters.map(a=>Math.hypot(...a.force)));Cf(n.marks,i.map(a=>({point:a.point,normal:a.normal,level:a.objectLevel})),n.options.contacts?e.clusters.map(a=>({point:a.point,normal:a.normal,share:Math.hypot(...a.force)/s})):[],.011*n.size,Bt("ring"));let r=(a,l)=>{if(Jg(a,l.map(({point:c,node:u,level:h})=>({point:p1(a.group,c),node:u,level:h})),n.size),a.wireframe)for(let{level:c}of l)l0(n,a,c)},o=t&&n.object.about.levels<=1?[]:e.contacts;r(n.object,o.map(a=>({point:a.point,node:a.objectNode,level:a.objectLevel}))),n.statics.forEach((a,l)=>r(a,o.filter(c=>c.body===l).map(c=>({point:c.point,node:c.sceneNode,level:c.sceneLevel}))))}function p1(n,e){return new W(...e).sub(n.position).applyQuaternion(n.quaternion.clone().conjugate()).toArray()}function c0(n,e){Object.assign(n.options,e);for(let t of Sr(n))mu(t,{wireframe:n.options.wireframe});n.last&&Bf(n,n.last),n.dirty=!0}function zf(n){let{clientWidth:e,clientHeight:t}=n.canvas;e===0||t===0||(n.resized=!0,n.view.camera.aspect=e/t,n.view.camera.fov=e<t?38:30,n.view.camera.updateProjectionMatrix(),mr(n.view))}function m1(n){let{clientWidth:e,clientHeight:t}=n.canvas,{ratio:i,shadows:s}=Of[n.pace.step];n.renderer.setPixelRatio(i*(n.plain?1:Math.min(2,devicePixelRatio))),e>0&&t>0&&n.renderer.setSize(e,t,!1),n.lights.key.castShadow=n.ground.visible=s,n.resized=!1,n.moved=!0}function u0(n){let e=n.renderer.getContext(),t=performance.now();if(n.fence&&!e.isContextLost()){if(e.getSyncParameter(n.fence,e.SYNC_STATUS)!==e.SIGNALED)return!1;e.deleteSync(n.fence),n.fence=null;let i=.001*(t-n.begun);n.rested=t+1e3*i0(i,n.plain),n.resized||=n0(n.pace,i)}return t<n.rested||!(n.dirty||n.view.changed)?!1:(n.resized&&m1(n),n.dirty=n.view.changed=!1,n.renderer.shadowMap.needsUpdate=n.moved,n.moved=!1,n.begun=t,n.renderer.render(n.scene,n.view.camera),n.fence=e.fenceSync(e.SYNC_GPU_COMMANDS_COMPLETE,0),e.flush(),!0)}function h0(n,e){let t=n.root.localToWorld(new W(...e));return 2*Math.tan(n.view.camera.fov*Math.PI/360)*Xm(n.view,t)*n.radius/Math.max(1,n.canvas.clientHeight)}var f0=.008;function d0(n){let{canvas:e}=n.stage,t={player:n,pointers:new Map,mode:null};e.addEventListener("contextmenu",i=>i.preventDefault()),e.addEventListener("pointerdown",i=>g1(t,i)),e.addEventListener("pointermove",i=>x1(t,i));for(let i of["pointerup","pointercancel"])e.addEventListener(i,s=>S1(t,s));return e.addEventListener("wheel",i=>M1(t,i),{passive:!1}),e.addEventListener("dblclick",i=>{i.button===2&&iu(n.stage.view)}),t}function g1(n,e){let{canvas:t}=n.player.stage;t.focus({preventScroll:!0}),t.setPointerCapture(e.pointerId),n.pointers.set(e.pointerId,{x:e.clientX,y:e.clientY}),e.pointerType==="touch"?n.pointers.size===1&&(n.mode=_1(n,e)&&n.player.mayMove()?"hand":"view"):e.button===0?n.mode=n.player.mayMove()?"hand":"view":n.mode=e.button===1||e.shiftKey?"pan":"view",n.mode==="hand"&&n.player.press(),t.classList.toggle("grabbing",n.mode==="hand")}function _1({player:{stage:n}},e){if(!n.object)return!1;let t=n.canvas.getBoundingClientRect(),i=new ft((e.clientX-t.left)/t.width*2-1,1-(e.clientY-t.top)/t.height*2),s=new ya;return s.setFromCamera(i,n.view.camera),s.intersectObject(n.object.finest.solid,!1).length>0}function x1(n,e){let t=n.pointers.get(e.pointerId);if(t){if(n.pointers.size===2)y1(n,e,t);else{let i=e.getCoalescedEvents?.()??[];for(let s of i.length>0?i:[e])v1(n,s,s.clientX-t.x,s.clientY-t.y),t.x=s.clientX,t.y=s.clientY}t.x=e.clientX,t.y=e.clientY,n.mode==="hand"&&n.player.give()}}function v1(n,e,t,i){let{stage:s}=n.player;if(!(t===0&&i===0)){if(n.mode==="view")return Wm(s.view,t,i);if(n.mode==="pan")return hf(s.view,t,i,s.canvas.clientHeight);if(n.mode==="hand")return e.ctrlKey||e.altKey||e.metaKey?Vf(n,t,i,0,e.timeStamp):e.shiftKey?Wa(n,0,0,-i,e.timeStamp):Wa(n,t,i,0,e.timeStamp)}}function Wa(n,e,t,i,s){let{stage:r,hand:o}=n.player,a=h0(r,n.player.grasp()),{right:l,up:c,forward:u}=Da(r.view),h=[0,1,2].map(f=>a*(e*l.getComponent(f)-t*c.getComponent(f)+i*u.getComponent(f)));fg(o,h,n.player.workspace()),bo(o,s/1e3),n.player.moved(!1)}function Vf(n,e,t,i,s){let{stage:r,hand:o}=n.player,{right:a,up:l,forward:c}=Da(r.view),u=n.player.workspace();cu(o,l.toArray(),f0*e,u),cu(o,a.toArray(),f0*t,u),i!==0&&cu(o,c.toArray(),i,u),bo(o,s/1e3),n.player.moved(!0)}function y1(n,e,t){let[i]=[...n.pointers].filter(([h])=>h!==e.pointerId).map(([,h])=>h),s={x:t.x-i.x,y:t.y-i.y},r={x:e.clientX-i.x,y:e.clientY-i.y},o=(Math.hypot(r.x,r.y)||1)/(Math.hypot(s.x,s.y)||1),a=Math.atan2(s.x*r.y-s.y*r.x,s.x*r.x+s.y*r.y),l=.5*(e.clientX-t.x),c=.5*(e.clientY-t.y),{stage:u}=n.player;n.mode==="hand"?(Vf(n,l,c,a,e.timeStamp),Wa(n,0,0,-200*Math.log(o),e.timeStamp)):(hf(u.view,l,c,u.canvas.clientHeight),uf(u.view,1/o))}function S1(n,e){n.pointers.delete(e.pointerId),!(n.pointers.size>0)&&(n.mode=null,n.player.stage.canvas.classList.remove("grabbing"))}function M1(n,e){e.preventDefault();let t=e.deltaY*(e.deltaMode===1?16:e.deltaMode===2?400:1);n.mode==="hand"?(Wa(n,0,0,-.4*t,e.timeStamp),n.player.give()):uf(n.player.stage.view,Math.exp(.0012*t))}var b1=.12;function p0(n,e,t,i){let s=[...navigator.getGamepads?.()??[]].find(a=>a?.connected);if(!s)return!1;let{player:r}=n,o=a=>Math.abs(s.axes[a]??0)>b1?s.axes[a]:0;if(s.buttons[0]?.pressed&&r.mayMove()&&r.press(),s.buttons[1]?.pressed&&r.letGo(),r.hand.clutch){let a=220*Math.min(.1,e),l=(s.buttons[7]?.value??0)-(s.buttons[6]?.value??0);(o(0)||o(1)||l)&&Wa(n,a*o(0),a*o(1),a*l,performance.now()),(o(2)||o(3))&&Vf(n,a*o(2),a*o(3),0,performance.now())}return w1(n,s,Math.min(1,t/i)),!0}function w1(n,e,t){let i=performance.now();!e.vibrationActuator?.playEffect||t<.02||i-(n.rumbled??-1e9)<60||(n.rumbled=i,e.vibrationActuator.playEffect("dual-rumble",{duration:80,strongMagnitude:t,weakMagnitude:.5*t}).catch(()=>{}))}function m0(n,e){let t={url:n,on:e,worker:new Worker("worker.js"),isOpen:!1,attempt:0,nextId:1,asked:new Map,received:0,bytes:0,posted:0,gone:0,stopped:!1};return t.worker.onmessage=({data:i})=>T1(t,i),t.worker.onerror=()=>y0(t,"The page could not start its worker. Reload the page."),t.worker.postMessage({open:n,origin:performance.timeOrigin}),t}function T1(n,e){if(!n.stopped)if(e.data!==void 0)try{A1(n,e.data)}finally{n.worker.postMessage({taken:1})}else e.opened?(Object.assign(n,{isOpen:!0,attempt:0}),n.on.opened()):e.lost?S0(n,e.lost):e.gone!==void 0&&(n.gone=e.gone)}function A1(n,e){if(!n.isOpen)return;n.received+=1,n.bytes+=typeof e=="string"?e.length:e.byteLength;let t=null;try{t=typeof e=="string"?ag(e):sg(e)}catch(i){if(!(i instanceof Ba))throw i;y0(n,`The program says something this page does not understand: ${i.message}. Reload the page.`);return}t.type==="ack"&&E1(n,t),n.on.message(t)}function E1(n,e){let t=n.asked.get(e.id);n.asked.delete(e.id),t?.(e)}function Mr(n,e){if(!n.isOpen)return Promise.resolve({ok:!1,reason:"The program is not connected."});let t=n.nextId;return n.nextId=t===2147483647?1:t+1,n.worker.postMessage({text:JSON.stringify({...e,id:t})}),new Promise(i=>n.asked.set(t,i))}function g0(n,e){n.isOpen&&e.length>0&&n.worker.postMessage({hand:e})}var _0=n=>n?.worker.postMessage({letGo:!0});function x0(n,e){return n.isOpen?(n.posted+=e.byteLength,n.worker.postMessage({bytes:e},[e]),!0):!1}var v0=n=>Math.max(0,n.posted-n.gone);function y0(n,e){n.stopped=!0,n.worker.postMessage({stop:!0}),S0(n,e)}function S0(n,e){Object.assign(n,{isOpen:!1,posted:0,gone:0,attempt:n.attempt+1});for(let t of n.asked.values())t({ok:!1,reason:"The connection was lost."});n.asked.clear(),n.on.lost(e)}function Tt(n,e="",t=""){return Object.assign(document.createElement(n),{className:e,textContent:t})}function C1({min:n,max:e,scale:t},i){let s=t==="log"?Math.log(i/n)/Math.log(e/n):(i-n)/(e-n);return Math.max(0,Math.min(1,s))}function M0({min:n,max:e,scale:t},i){return t==="log"?n*(e/n)**i:n+i*(e-n)}var Xa=n=>String(Number(n.toPrecision(3)));function b0(n,e){return{parent:n,ask:e,rows:new Map}}function w0(n,e){let t=new Set(e.map(i=>i.name));for(let[i,s]of n.rows)t.has(i)||(s.box.remove(),n.rows.delete(i));for(let i of e)n.rows.has(i.name)||n.rows.set(i.name,P1(n,i)),I1(n.rows.get(i.name),i)}function R1(n,e){let t=Tt("div","parameter"),i=Tt("div","parameter-top"),s=Tt("span","words"),r=Tt("label","",e.label),o=Tt("p","note"),a=Tt("p","refusal"),l=Tt("p","warning");a.setAttribute("role","alert"),s.setAttribute("role","radiogroup"),s.setAttribute("aria-label",e.label);let c=e.choices.map((h,f)=>{let p=Object.assign(Tt("button","chip-button",h),{type:"button"});return p.setAttribute("role","radio"),p.addEventListener("click",()=>{u.parameter.value!==f&&qa(n,u,f)}),s.append(p),p});i.append(r,s),t.append(i,o,a,l),n.parent.append(t);let u={box:t,buttons:c,help:o,refusal:a,warning:l,parameter:e,busy:!1,next:null};return u}function P1(n,e){if(e.kind==="choice")return R1(n,e);let t=Tt("div","parameter"),i=Tt("label","",e.label),s=Object.assign(Tt("input"),{type:"range",min:0,max:1,step:.001,id:`parameter-${e.name}`});i.htmlFor=s.id;let r=Object.assign(Tt("input","value"),{type:"text",inputMode:"decimal"});r.setAttribute("aria-label",`${e.label}, ${e.unit}`);let o=Tt("span","unit",e.unit),a=Tt("p","note"),l=Tt("p","refusal");l.setAttribute("role","alert");let c=Tt("div","parameter-top"),u=Tt("p","warning"),h={box:t,slider:s,number:r,help:a,refusal:l,warning:u,parameter:e,busy:!1,next:null,on:null};return e.kind==="optional"&&(h.on=Object.assign(Tt("input","switch"),{type:"checkbox"}),h.on.setAttribute("aria-label",`${e.label} on`),h.kept=e.value||M0(e,.5),h.on.addEventListener("change",()=>qa(n,h,h.on.checked?Number(Xa(h.kept)):0)),c.append(h.on)),c.append(i,r,o),t.append(c,s,a,l,u),n.parent.append(t),s.addEventListener("input",()=>{let f=Number(Xa(M0(h.parameter,Number(s.value))));r.value=Xa(f),qa(n,h,f)}),r.addEventListener("change",()=>{let f=Number(r.value.replace(",","."));r.value.trim()!==""&&Number.isFinite(f)?qa(n,h,f):T0(h,`"${r.value}" is not a number.`)}),h}async function qa(n,e,t){if(e.busy){e.next=t;return}e.busy=!0;let i=await n.ask(e.parameter.name,t);if(e.busy=!1,e.next!==null){let s=e.next;e.next=null,qa(n,e,s);return}if(!i.ok){T0(e,i.reason??"Refused.");return}e.refusal.textContent="",e.parameter={...e.parameter,value:i.value??t},Gf(e),e.box.classList.remove("changed"),e.box.offsetWidth,e.box.classList.add("changed")}function T0(n,e){let{value:t,unit:i,choices:s}=n.parameter,r=s?.length>0?s[t]:n.on&&t===0?"off":`${Xa(t)} ${i}`.trim();n.refusal.textContent=`${e.replace(/[.]?$/,".")} It stays at ${r}.`,Gf(n)}function I1(n,e){n.parameter=e;let t=e.begins_again?" Begins again.":"";n.help.textContent=e.locked??`${e.help??""}${t}`,n.warning.textContent=e.warning?`Risky: ${e.warning}.`:"";let i=!!e.locked;n.box.classList.toggle("locked",i);for(let s of[n.slider,n.number,n.on,...n.buttons??[]])s&&(s.disabled=i);!n.busy&&document.activeElement!==n.number&&Gf(n)}function Gf(n){let{value:e}=n.parameter;if(n.buttons?.forEach((i,s)=>i.setAttribute("aria-checked",String(s===e))),n.buttons)return;let t=n.on!==null&&e===0;n.on&&(n.on.checked=!t,t||(n.kept=e),n.box.classList.toggle("off",t)),n.slider.value=C1(n.parameter,t?n.kept:e),n.number.value=t?"off":Xa(e)}var L1=200;function A0(n,e){let t=Tt("div",`event ${e.kind}`);for(t.append(Tt("time","",`${$s(e.time)} s`),Tt("span","",ou(e))),n.prepend(t);n.childElementCount>L1;)n.lastChild.remove()}var N1=[["Drag","moves the hand in the plane of the screen"],["Wheel while dragging, or Shift + drag","moves it away from you and back"],["Ctrl or Alt + drag","turns it"],["Space","lets go, or takes hold"],["Right drag, wheel","turns and zooms the view; middle drag shifts it"],["Touch","one finger on the object moves it, a second turns and lifts it; beside it fingers move the view"],["Gamepad","sticks move and turn, triggers push and pull, A holds, B lets go; it rumbles with the force"],["P . R O","pause, one step, begin again, open a scene"],["F L G C A","fit the view; levels of detail, ghost, contacts, arrows on and off"]];function E0(n){let e=Tt("h2","","The mouse is the hand"),t=Tt("p","lead","Drag the blue object: the ghost shows where your hand is, the object where it may be, and the line between them, as long as the force is strong, is what a haptic device would let you feel."),i=Tt("dl");for(let[o,a]of N1)i.append(Tt("dt","",o),Tt("dd","",a));let s=Tt("p","note");s.append(wo("force","force on the hand"),wo("torque","torque, turning along the arc"),wo("ring","clusters of contacts"),wo("levels","dots: contacts with their normals, in the colour of their level of detail"),wo("contact","under constraints, discs: planes that the object keeps off, with the points they keep off"),wo("press","those that press, with their force and the cone it may lie in"));let r=Object.assign(Tt("button","primary","Close"),{type:"button"});r.addEventListener("click",()=>n.close()),n.addEventListener("click",o=>{o.target===n&&n.close()}),n.replaceChildren(e,t,i,s,r)}function wo(n,e){let t=Tt("span",`key ${n}`,e);return t.prepend(Tt("i")),t}var D1="uplot",U1="u-hz",F1="u-vt",O1="u-title",B1="u-wrap",k1="u-under",z1="u-over",V1="u-axis",Tr="u-off",G1="u-select",H1="u-cursor-x",W1="u-cursor-y",X1="u-cursor-pt",q1="u-legend",$1="u-live",Y1="u-inline",Z1="u-series",J1="u-marker",C0="u-label",K1="u-value",Ya="width",Za="height";var R0="bottom",To="left",Hf="right",od="#000",P0=od+"0",Wf="mousemove",I0="mousedown",Xf="mouseup",L0="mouseenter",N0="mouseleave",D0="dblclick",j1="resize",Q1="scroll",U0="change",Mu="dppxchange",ad="--",Lo=typeof window<"u",Jf=Lo?document:null,Eo=Lo?window:null,eT=Lo?navigator:null,bt,xu;function Kf(){let n=devicePixelRatio;bt!=n&&(bt=n,xu&&Qf(U0,xu,Kf),xu=matchMedia(`(min-resolution: ${bt-.001}dppx) and (max-resolution: ${bt+.001}dppx)`),Ar(U0,xu,Kf),Eo.dispatchEvent(new CustomEvent(Mu)))}function hi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function jf(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Xt(n,e,t){n.style[e]=t+"px"}function Ui(n,e,t,i){let s=Jf.createElement(n);return e!=null&&hi(s,e),t?.insertBefore(s,i),s}function Mi(n,e){return Ui("div",n,e)}var F0=new WeakMap;function ts(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=F0.get(n);r!=o&&(n.style.transform=r,F0.set(n,r),e<0||t<0||e>i||t>s?hi(n,Tr):jf(n,Tr))}var O0=new WeakMap;function B0(n,e,t){let i=e+t,s=O0.get(n);i!=s&&(O0.set(n,i),n.style.background=e,n.style.borderColor=t)}var k0=new WeakMap;function z0(n,e,t,i){let s=e+""+t,r=k0.get(n);s!=r&&(k0.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var ld={passive:!0},tT={...ld,capture:!0};function Ar(n,e,t,i){e.addEventListener(n,t,i?tT:ld)}function Qf(n,e,t,i){e.removeEventListener(n,t,ld)}Lo&&Kf();function Fi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:fi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function p_(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var m_=n=>n!=null,g_=n=>n!=null&&n>0,Tu=p_(m_),nT=p_(g_);function iT(n,e,t,i=0,s=!1){let r=s?nT:Tu,o=s?g_:m_;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Dt,l??-Dt]}function Au(n,e,t,i){let s=H0(n),r=H0(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Ts:__,a=s==1?fi:bi,l=r==1?bi:fi,c=a(o(bn(n))),u=l(o(bn(e))),h=Co(t,c),f=Co(t,u);return t==10&&(c<0&&(h=Ut(h,-c)),u<0&&(f=Ut(f,-u))),i||t==2?(n=h*s,e=f*r):(n=S_(n,h),e=Eu(e,f)),[n,e]}function cd(n,e,t,i){let s=Au(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var ud=.1,V0={mode:3,pad:ud},Ka={pad:0,soft:null,mode:0},sT={min:Ka,max:Ka};function bu(n,e,t,i){return Cu(t)?G0(n,e,t):(Ka.pad=t,Ka.soft=i?0:null,Ka.mode=i?3:0,G0(n,e,sT))}function St(n,e){return n??e}function rT(n,e,t){for(e=St(e,0),t=St(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function G0(n,e,t){let i=t.min,s=t.max,r=St(i.pad,0),o=St(s.pad,0),a=St(i.hard,-Dt),l=St(s.hard,Dt),c=St(i.soft,Dt),u=St(s.soft,-Dt),h=St(i.mode,0),f=St(s.mode,0),p=e-n,g=Ts(p),S=Jn(bn(n),bn(e)),d=Ts(S),m=bn(d-g);(p<1e-24||m>10)&&(p=0,(n==0||e==0)&&(p=1e-24,h==2&&c!=Dt&&(r=0),f==2&&u!=-Dt&&(o=0)));let y=p||S||1e3,C=Ts(y),b=Co(10,fi(C)),P=y*(p==0?n==0?.1:1:r),A=Ut(S_(n-P,b/10),24),x=n>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:Dt,T=Jn(a,A<x&&n>=x?x:Oi(x,A)),B=y*(p==0?e==0?.1:1:o),D=Ut(Eu(e+B,b/10),24),I=e<=u&&(f==1||f==3&&D>=u||f==2&&D<=u)?u:-Dt,k=Oi(l,D>I&&e<=I?I:Jn(I,D));return T==k&&T==0&&(k=100),[T,k]}var oT=new Intl.NumberFormat(Lo?eT.language:"en-US"),hd=n=>oT.format(n),di=Math,Su=di.PI,bn=di.abs,fi=di.floor,Mn=di.round,bi=di.ceil,Oi=di.min,Jn=di.max,Co=di.pow,H0=di.sign,Ts=di.log10,__=di.log2,aT=(n,e=1)=>di.sinh(n)*e,qf=(n,e=1)=>di.asinh(n/e),Dt=1/0;function W0(n){return(Ts((n^n>>31)-(n>>31))|0)+1}function ed(n,e,t){return Oi(Jn(n,e),t)}function x_(n){return typeof n=="function"}function gt(n){return x_(n)?n:()=>n}var lT=()=>{},v_=n=>n,y_=(n,e)=>e,cT=n=>null,X0=n=>!0,q0=(n,e)=>n==e,uT=/\.\d*?(?=9{6,}|0{6,})/gm,Er=n=>{if(b_(n)||Ks.has(n))return n;let e=`${n}`,t=e.match(uT);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Er(s)}e${r}`}return Ut(n,i)};function br(n,e){return Er(Ut(Er(n/e))*e)}function Eu(n,e){return Er(bi(Er(n/e))*e)}function S_(n,e){return Er(fi(Er(n/e))*e)}function Ut(n,e=0){if(b_(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Mn(i)/t}var Ks=new Map;function M_(n){return((""+n).split(".")[1]||"").length}function Qa(n,e,t,i){let s=[],r=i.map(M_);for(let o=e;o<t;o++){let a=bn(o),l=Ut(Co(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:Ut(u,h);s.push(f),Ks.set(f,h)}}return s}var ja={},fd=[],Ro=[null,null],Js=Array.isArray,b_=Number.isInteger,hT=n=>n===void 0;function $0(n){return typeof n=="string"}function Cu(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function fT(n){return n!=null&&typeof n=="object"}var dT=Object.getPrototypeOf(Uint8Array),w_="__proto__";function Po(n,e=Cu){let t;if(Js(n)){let i=n.find(s=>s!=null);if(Js(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Po(n[s],e)}else t=n.slice()}else if(n instanceof dT)t=n.slice();else if(e(n)){t={};for(let i in n)i!=w_&&(t[i]=Po(n[i],e))}else t=n;return t}function pn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=w_&&(Cu(n[s])?pn(n[s],Po(i[s])):n[s]=Po(i[s]))}return n}var pT=0,mT=1,gT=2;function _T(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function xT(n,e){if(ST(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return MT(o[0])||(o=yT(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:mT,p=[];for(let g=0;g<u.length;g++){let S=u[g],d=r.get(l[g]);S===null?f!=pT&&(h[d]=S,f==gT&&p.push(d)):h[d]=S}_T(h,p,s),i.push(h)}}return i}var vT=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function yT(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function ST(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function MT(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Jn(1,fi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var T_=["January","February","March","April","May","June","July","August","September","October","November","December"],A_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function E_(n){return n.slice(0,3)}var bT=A_.map(E_),wT=T_.map(E_),TT={MMMM:T_,MMM:wT,WWWW:A_,WWW:bT};function $a(n){return(n<10?"0":"")+n}function AT(n){return(n<10?"00":n<100?"0":"")+n}var ET={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>$a(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>$a(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>$a(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>$a(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>$a(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>AT(n.getMilliseconds())};function dd(n,e){e=e||TT;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?ET[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var CT=new Intl.DateTimeFormat().resolvedOptions().timeZone;function RT(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==CT?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var C_=n=>n%1==0,wu=[1,2,2.5,5],PT=Qa(10,-32,0,wu),R_=Qa(10,0,32,wu),IT=R_.filter(C_),wr=PT.concat(R_),pd=`
`,P_="{YYYY}",Y0=pd+P_,I_="{M}/{D}",Ja=pd+I_,vu=Ja+"/{YY}",L_="{aa}",LT="{h}:{mm}",Ao=LT+L_,Z0=pd+Ao,J0=":{ss}",At=null;function N_(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Qa(10,0,3,wu).filter(C_):Qa(10,-3,0,wu)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,P_,At,At,At,At,At,At,1],[s*28,"{MMM}",Y0,At,At,At,At,At,1],[s,I_,Y0,At,At,At,At,At,1],[i,"{h}"+L_,vu,At,Ja,At,At,At,1],[t,Ao,vu,At,Ja,At,At,At,1],[e,J0,vu+" "+Ao,At,Ja+" "+Ao,At,Z0,At,1],[n,J0+".{fff}",vu+" "+Ao,At,Ja+" "+Ao,At,Z0,At,1]];function u(h){return(f,p,g,S,d,m)=>{let y=[],C=d>=o,b=d>=r&&d<o,P=h(g),A=Ut(P*n,3),x=$f(P.getFullYear(),C?0:P.getMonth(),b||C?1:P.getDate()),T=Ut(x*n,3);if(b||C){let B=b?d/r:0,D=C?d/o:0,I=A==T?A:Ut($f(x.getFullYear()+D,x.getMonth()+B,1)*n,3),k=new Date(Mn(I/n)),V=k.getFullYear(),N=k.getMonth();for(let H=0;I<=S;H++){let $=$f(V+D*H,N+B*H,1),G=$-h(Ut($*n,3));I=Ut((+$+G)*n,3),I<=S&&y.push(I)}}else{let B=d>=s?s:d,D=fi(g)-fi(A),I=T+D+Eu(A-T,B);y.push(I);let k=h(I),V=k.getHours()+k.getMinutes()/t+k.getSeconds()/i,N=d/i,H=f.axes[p]._space,$=m/H;for(;I=Ut(I+d,n==1?0:3),!(I>S);)if(N>1){let G=fi(Ut(V+N,6))%24,j=h(I).getHours()-G;j>1&&(j=-1),I-=j*i,V=(V+N)%24;let ie=y[y.length-1];Ut((I-ie)/d,3)*$>=.7&&y.push(I)}else y.push(I)}return y}}return[l,c,u]}var[NT,DT,UT]=N_(1),[FT,OT,BT]=N_(.001);Qa(2,-53,53,[1]);function K0(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function j0(n,e){return(t,i,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,u,h,f,p;return i.map(g=>{let S=n(g),d=S.getFullYear(),m=S.getMonth(),y=S.getDate(),C=S.getHours(),b=S.getMinutes(),P=S.getSeconds(),A=d!=l&&a[2]||m!=c&&a[3]||y!=u&&a[4]||C!=h&&a[5]||b!=f&&a[6]||P!=p&&a[7]||a[1];return l=d,c=m,u=y,h=C,f=b,p=P,A(S)})}}function kT(n,e){let t=dd(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function $f(n,e,t){return new Date(n,e,t)}function Q0(n,e){return e(n)}var zT="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function e_(n,e){return(t,i,s,r)=>r==null?ad:e(n(i))}function VT(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function GT(n,e){return n.series[e].fill(n,e)}var HT={show:!0,live:!0,isolate:!1,mount:lT,markers:{show:!0,width:2,stroke:VT,fill:GT,dash:"solid"},idx:null,idxs:null,values:[]};function WT(n,e){let t=n.cursor.points,i=Mi(),s=t.size(n,e);Xt(i,Ya,s),Xt(i,Za,s);let r=s/-2;Xt(i,"marginLeft",r),Xt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Xt(i,"borderWidth",o),i}function XT(n,e){let t=n.series[e].points;return t._fill||t._stroke}function qT(n,e){let t=n.series[e].points;return t._stroke||t._fill}function $T(n,e){return n.series[e].points.size}var Yf=[0,0];function YT(n,e,t){return Yf[0]=e,Yf[1]=t,Yf}function yu(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Zf(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var ZT={show:!0,x:!0,y:!0,lock:!1,move:YT,points:{one:!1,show:WT,size:$T,width:0,stroke:qT,fill:XT},bind:{mousedown:yu,mouseup:yu,click:yu,dblclick:yu,mousemove:Zf,mouseleave:Zf,mouseenter:Zf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},D_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},md=pn({},D_,{filter:y_}),U_=pn({},md,{size:10}),F_=pn({},D_,{show:!1}),gd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',O_="bold "+gd,B_=1.5,t_={show:!0,scale:"x",stroke:od,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:O_,side:2,grid:md,ticks:U_,border:F_,font:gd,lineGap:B_,rotate:0},JT="Value",KT="Time",n_={show:!0,scale:"x",auto:!1,sorted:1,min:Dt,max:-Dt,idxs:[]};function jT(n,e,t,i,s){return e.map(r=>r==null?"":hd(r))}function QT(n,e,t,i,s,r,o){let a=[],l=Ks.get(s)||0;t=o?t:Ut(Eu(t,s),l);for(let c=t;c<=i;c=Ut(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function td(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Ts:__,u=fi(c(t));s=Co(l,u),l==10&&(s=wr[Fi(s,wr)]);let h=t,f=s*l;l==10&&(f=wr[Fi(f,wr)]);do a.push(h),h=h+s,l==10&&!Ks.has(h)&&(h=Ut(h,Ks.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=wr[Fi(f,wr)]));while(h<=i);return a}function eA(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?td(n,e,Jn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?td(n,e,Jn(l,-i),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var k_=/./,tA=/[12357]/,nA=/[125]/,i_=/1/,nd=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function iA(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?k_:l(7,o)-u>=c?tA:l(5,o)-u>=c?nA:i_;if(h==i_){let f=bn(l(1,o)-u);if(f<c)return nd(e.slice().reverse(),a.distr,h,bi(c/f)).reverse()}return nd(e,a.distr,h,1)}function sA(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=bn(l(1,o)-l(2,o));return c<a?nd(e.slice().reverse(),3,k_,bi(a/c)).reverse():e}function rA(n,e,t,i){return i==null?ad:e==null?"":hd(e)}var s_={show:!0,scale:"y",stroke:od,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:O_,side:3,grid:md,ticks:U_,border:F_,font:gd,lineGap:B_,rotate:0};function oA(n,e){let t=3+(n||1)*2;return Ut(t*e,3)}function aA(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=bn(o-r),l=n.series[e],c=a/(l.points.space*bt);return i[1]-i[0]<=c}var r_={scale:null,auto:!0,sorted:0,min:Dt,max:-Dt},z_=(n,e,t,i,s)=>s,o_={show:!0,auto:!0,sorted:0,gaps:z_,alpha:1,facets:[pn({},r_,{scale:"x"}),pn({},r_,{scale:"y"})]},a_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:z_,alpha:1,points:{show:aA,filter:null},values:null,min:Dt,max:-Dt,idxs:[],path:null,clip:null};function lA(n,e,t,i,s){return t/10}var V_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},cA=pn({},V_,{time:!1,ori:1}),l_={};function G_(n,e){let t=l_[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(l_[n]=t)),t}var Io=1,id=2;function Cr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,p=a.top,g=a.width,S=a.height,d=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,h,d,m,f,p,g,S,Pu,No,Lu,W_,q_):t(s,l,c,u,h,m,d,p,f,S,g,Iu,Do,vd,X_,$_)}function _d(n,e){let t=0,i=0,s=St(n.bands,fd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function uA(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function As(n,e,t,i,s,r){return Cr(n,e,(o,a,l,c,u,h,f,p,g,S,d)=>{let m=o.pxRound,y=c.dir*(c.ori==0?1:-1),C=c.ori==0?No:Do,b,P;y==1?(b=t,P=i):(b=i,P=t);let A=m(h(a[b],c,S,p)),x=m(f(l[b],u,d,g)),T=m(h(a[P],c,S,p)),B=m(f(r==1?u.max:u.min,u,d,g)),D=new Path2D(s);return C(D,T,B),C(D,A,B),C(D,A,x),D})}function Ru(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Lu:vd,l=t;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let p=f[0]-l;p>0&&a(o,l,i,p,i+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function hA(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function xd(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let p=r(n[h]),g=f==h?p:r(n[f]),S=h-s;p=o<=0&&S>=0&&S<l?r(n[S]):p;let m=f+s;g=o>=0&&m>=0&&m<l?r(n[m]):g,g>=p&&a.push([p,g])}return a}function c_(n){return n==0?v_:n==1?Mn:e=>br(e,n)}function H_(n){let e=n==0?Pu:Iu,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Oi(c,a/2,l/2),u=Oi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Pu=(n,e,t)=>{n.moveTo(e,t)},Iu=(n,e,t)=>{n.moveTo(t,e)},No=(n,e,t)=>{n.lineTo(e,t)},Do=(n,e,t)=>{n.lineTo(t,e)},Lu=H_(0),vd=H_(1),W_=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},X_=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},q_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},$_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function Y_(n){return(e,t,i,s,r)=>Cr(e,t,(o,a,l,c,u,h,f,p,g,S,d)=>{let{pxRound:m,points:y}=o,C,b;c.ori==0?(C=Pu,b=W_):(C=Iu,b=X_);let P=Ut(y.width*bt,3),A=(y.size-y.width)/2*bt,x=Ut(A*2,3),T=new Path2D,B=new Path2D,{left:D,top:I,width:k,height:V}=e.bbox;Lu(B,D-x,I-x,k+x*2,V+x*2);let N=H=>{if(l[H]!=null){let $=m(h(a[H],c,S,p)),G=m(f(l[H],u,d,g));C(T,$+A,G),b(T,$,G,A,0,Su*2)}};if(r)r.forEach(N);else for(let H=i;H<=s;H++)N(H);return{stroke:P>0?T:null,fill:T,clip:B,flags:Io|id}})}function Z_(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var fA=Z_(No),dA=Z_(Do);function J_(n){let e=St(n?.alignGaps,0);return(t,i,s,r)=>Cr(t,i,(o,a,l,c,u,h,f,p,g,S,d)=>{[s,r]=Tu(l,s,r);let m=o.pxRound,y=V=>m(h(V,c,S,p)),C=V=>m(f(V,u,d,g)),b,P;c.ori==0?(b=No,P=fA):(b=Do,P=dA);let A=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Io},T=x.stroke,B=!1;if(r-s>=S*4){let V=ue=>t.posToVal(ue,c.key,!0),N=null,H=null,$,G,le,J=y(a[A==1?s:r]),j=y(a[s]),ie=y(a[r]),he=V(A==1?j+1:ie-1);for(let ue=A==1?s:r;ue>=s&&ue<=r;ue+=A){let Q=a[ue],xe=(A==1?Q<he:Q>he)?J:y(Q),Ee=l[ue];xe==J?Ee!=null?(G=Ee,N==null?(b(T,xe,C(G)),$=N=H=G):G<N?N=G:G>H&&(H=G)):Ee===null&&(B=!0):(N!=null&&P(T,J,C(N),C(H),C($),C(G)),Ee!=null?(G=Ee,b(T,xe,C(G)),N=H=$=G):(N=H=null,Ee===null&&(B=!0)),J=xe,he=V(J+A))}N!=null&&N!=H&&le!=J&&P(T,J,C(N),C(H),C($),C(G))}else for(let V=A==1?s:r;V>=s&&V<=r;V+=A){let N=l[V];N===null?B=!0:N!=null&&b(T,y(a[V]),C(N))}let[I,k]=_d(t,i);if(o.fill!=null||I!=0){let V=x.fill=new Path2D(T),N=o.fillTo(t,i,o.min,o.max,I),H=C(N),$=y(a[s]),G=y(a[r]);A==-1&&([G,$]=[$,G]),b(V,G,H),b(V,$,H)}if(!o.spanGaps){let V=[];B&&V.push(...xd(a,l,s,r,A,y,e)),x.gaps=V=o.gaps(t,i,s,r,V),x.clip=Ru(V,c.ori,p,g,S,d)}return k!=0&&(x.band=k==2?[As(t,i,s,r,T,-1),As(t,i,s,r,T,1)]:As(t,i,s,r,T,k)),x})}function pA(n){let e=St(n.align,1),t=St(n.ascDesc,!1),i=St(n.alignGaps,0),s=St(n.extend,!1);return(r,o,a,l)=>Cr(r,o,(c,u,h,f,p,g,S,d,m,y,C)=>{[a,l]=Tu(h,a,l);let b=c.pxRound,{left:P,width:A}=r.bbox,x=j=>b(g(j,f,y,d)),T=j=>b(S(j,p,C,m)),B=f.ori==0?No:Do,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Io},I=D.stroke,k=f.dir*(f.ori==0?1:-1),V=T(h[k==1?a:l]),N=x(u[k==1?a:l]),H=N,$=N;s&&e==-1&&($=P,B(I,$,V)),B(I,N,V);for(let j=k==1?a:l;j>=a&&j<=l;j+=k){let ie=h[j];if(ie==null)continue;let he=x(u[j]),ue=T(ie);e==1?B(I,he,V):B(I,H,ue),B(I,he,ue),V=ue,H=he}let G=H;s&&e==1&&(G=P+A,B(I,G,V));let[le,J]=_d(r,o);if(c.fill!=null||le!=0){let j=D.fill=new Path2D(I),ie=c.fillTo(r,o,c.min,c.max,le),he=T(ie);B(j,G,he),B(j,$,he)}if(!c.spanGaps){let j=[];j.push(...xd(u,h,a,l,k,x,i));let ie=c.width*bt/2,he=t||e==1?ie:-ie,ue=t||e==-1?-ie:ie;j.forEach(Q=>{Q[0]+=he,Q[1]+=ue}),D.gaps=j=c.gaps(r,o,a,l,j),D.clip=Ru(j,f.ori,d,m,y,C)}return J!=0&&(D.band=J==2?[As(r,o,a,l,I,-1),As(r,o,a,l,I,1)]:As(r,o,a,l,I,J)),D})}function u_(n,e,t,i,s,r,o=Dt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=bn(n[l]-n[a]);u<c&&(c=u,o=bn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function mA(n){n=n||ja;let e=St(n.size,[.6,Dt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=gt(s),o=1-e[0],a=St(e[1],Dt),l=St(e[2],1),c=St(n.disp,ja),u=St(n.each,p=>{}),{fill:h,stroke:f}=c;return(p,g,S,d)=>Cr(p,g,(m,y,C,b,P,A,x,T,B,D,I)=>{let k=m.pxRound,V=t,N=i*bt,H=a*bt,$=l*bt,G,le;b.ori==0?[G,le]=r(p,g):[le,G]=r(p,g);let J=b.dir*(b.ori==0?1:-1),j=b.ori==0?Lu:vd,ie=b.ori==0?u:(Re,qe,st,be,Nt,ze,Xe)=>{u(Re,qe,st,Nt,be,Xe,ze)},he=St(p.bands,fd).find(Re=>Re.series[0]==g),ue=he!=null?he.dir:0,Q=m.fillTo(p,g,m.min,m.max,ue),pe=k(x(Q,P,I,B)),xe,Ee,Me,He=D,it=k(m.width*bt),Ve=!1,ct=null,ot=null,tt=null,qt=null;h!=null&&(it==0||f!=null)&&(Ve=!0,ct=h.values(p,g,S,d),ot=new Map,new Set(ct).forEach(Re=>{Re!=null&&ot.set(Re,new Path2D)}),it>0&&(tt=f.values(p,g,S,d),qt=new Map,new Set(tt).forEach(Re=>{Re!=null&&qt.set(Re,new Path2D)})));let{x0:Ft,size:an}=c;if(Ft!=null&&an!=null){V=1,y=Ft.values(p,g,S,d),Ft.unit==2&&(y=y.map(st=>p.posToVal(T+st*D,b.key,!0)));let Re=an.values(p,g,S,d);an.unit==2?Ee=Re[0]*D:Ee=A(Re[0],b,D,T)-A(0,b,D,T),He=u_(y,C,A,b,D,T,He),Me=He-Ee+N}else He=u_(y,C,A,b,D,T,He),Me=He*o+N,Ee=He-Me;Me<1&&(Me=0),it>=Ee/2&&(it=0),Me<5&&(k=v_);let Pt=Me>0,wn=He-Me-(Pt?it:0);Ee=k(ed(wn,$,H)),xe=(V==0?Ee/2:V==J?0:Ee)-V*J*((V==0?N/2:0)+(Pt?it/2:0));let xt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},gn=Ve?null:new Path2D,Kt=null;if(he!=null)Kt=p.data[he.series[1]];else{let{y0:Re,y1:qe}=c;Re!=null&&qe!=null&&(C=qe.values(p,g,S,d),Kt=Re.values(p,g,S,d))}let ln=G*Ee,F=le*Ee;for(let Re=J==1?S:d;Re>=S&&Re<=d;Re+=J){let qe=C[Re];if(qe==null)continue;if(Kt!=null){let X=Kt[Re]??0;if(qe-X==0)continue;pe=x(X,P,I,B)}let st=b.distr!=2||c!=null?y[Re]:Re,be=A(st,b,D,T),Nt=x(St(qe,Q),P,I,B),ze=k(be-xe),Xe=k(Jn(Nt,pe)),E=k(Oi(Nt,pe)),v=Xe-E;if(qe!=null){let X=qe<0?F:ln,ce=qe<0?ln:F;Ve?(it>0&&tt[Re]!=null&&j(qt.get(tt[Re]),ze,E+fi(it/2),Ee,Jn(0,v-it),X,ce),ct[Re]!=null&&j(ot.get(ct[Re]),ze,E+fi(it/2),Ee,Jn(0,v-it),X,ce)):j(gn,ze,E+fi(it/2),Ee,Jn(0,v-it),X,ce),ie(p,g,Re,ze-it/2,E,Ee+it,v)}}return it>0?xt.stroke=Ve?qt:gn:Ve||(xt._fill=m.width==0?m._fill:m._stroke??m._fill,xt.width=0),xt.fill=Ve?ot:gn,xt})}function gA(n,e){let t=St(e?.alignGaps,0);return(i,s,r,o)=>Cr(i,s,(a,l,c,u,h,f,p,g,S,d,m)=>{[r,o]=Tu(c,r,o);let y=a.pxRound,C=G=>y(f(G,u,d,g)),b=G=>y(p(G,h,m,S)),P,A,x;u.ori==0?(P=Pu,x=No,A=q_):(P=Iu,x=Do,A=$_);let T=u.dir*(u.ori==0?1:-1),B=C(l[T==1?r:o]),D=B,I=[],k=[];for(let G=T==1?r:o;G>=r&&G<=o;G+=T)if(c[G]!=null){let J=l[G],j=C(J);I.push(D=j),k.push(b(c[G]))}let V={stroke:n(I,k,P,x,A,y),fill:null,clip:null,band:null,gaps:null,flags:Io},N=V.stroke,[H,$]=_d(i,s);if(a.fill!=null||H!=0){let G=V.fill=new Path2D(N),le=a.fillTo(i,s,a.min,a.max,H),J=b(le);x(G,D,J),x(G,B,J)}if(!a.spanGaps){let G=[];G.push(...xd(l,c,r,o,T,C,t)),V.gaps=G=a.gaps(i,s,r,o,G),V.clip=Ru(G,u.ori,g,S,d,m)}return $!=0&&(V.band=$==2?[As(i,s,r,o,N,-1),As(i,s,r,o,N,1)]:As(i,s,r,o,N,$)),V})}function _A(n){return gA(xA,n)}function xA(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,e[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,n[f+1],e[f+1])}return a}var sd=new Set;function h_(){for(let n of sd)n.syncRect(!0)}Lo&&(Ar(j1,Eo,h_),Ar(Q1,Eo,h_,!0),Ar(Mu,Eo,()=>{Un.pxRatio=bt}));var vA=J_(),yA=Y_();function f_(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>rd(r,o,e,t))}function SA(n,e){return n.map((t,i)=>i==0?{}:pn({},e,t))}function rd(n,e,t,i){return pn({},e==0?t:i,n)}function K_(n,e,t){return e==null?Ro:[e,t]}var MA=K_;function bA(n,e,t){return e==null?Ro:bu(e,t,ud,!0)}function j_(n,e,t,i){return e==null?Ro:Au(e,t,n.scales[i].log,!1)}var wA=j_;function Q_(n,e,t,i){return e==null?Ro:cd(e,t,n.scales[i].log,!1)}var TA=Q_;function AA(n,e,t,i,s){let r=Jn(W0(n),W0(e)),o=e-n,a=Fi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Ks.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function d_(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Mn((t=+s)*bt))+"px"),[n,e,t]}function EA(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Ut(e[2]*bt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Un(n,e,t){let i={mode:St(n.mode,1)},s=i.mode;function r(_,M,R,L){let z=M.valToPct(_);return L+R*(M.dir==-1?1-z:z)}function o(_,M,R,L){let z=M.valToPct(_);return L+R*(M.dir==-1?z:1-z)}function a(_,M,R,L){return M.ori==0?r(_,M,R,L):o(_,M,R,L)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Mi(D1);if(n.id!=null&&(c.id=n.id),hi(c,n.class),n.title){let _=Mi(O1,c);_.textContent=n.title}let u=Ui("canvas"),h=i.ctx=u.getContext("2d"),f=Mi(B1,c);Ar("click",f,_=>{_.target===g&&(zt!=Fr||$t!=Or)&&In.click(i,_)},!0);let p=i.under=Mi(k1,f);f.appendChild(u);let g=i.over=Mi(z1,f);n=Po(n);let S=+St(n.pxAlign,1),d=c_(S);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});let m=n.ms||.001,y=i.series=s==1?f_(n.series||[],n_,a_,!1):SA(n.series||[null],o_),C=i.axes=f_(n.axes||[],t_,s_,!0),b=i.scales={},P=i.bands=n.bands||[];P.forEach(_=>{_.fill=gt(_.fill||null),_.dir=St(_.dir,-1)});let A=s==2?y[1].facets[0].scale:y[0].scale,x={axes:os,series:ht},T=(n.drawOrder||["axes","series"]).map(_=>x[_]);function B(_){let M=_.distr==3?R=>Ts(R>0?R:_.clamp(i,R,_.min,_.max,_.key)):_.distr==4?R=>qf(R,_.asinh):_.distr==100?R=>_.fwd(R):R=>R;return R=>{let L=M(R),{_min:z,_max:Z}=_,oe=Z-z;return(L-z)/oe}}function D(_){let M=b[_];if(M==null){let R=(n.scales||ja)[_]||ja;if(R.from!=null){D(R.from);let L=pn({},b[R.from],R,{key:_});L.valToPct=B(L),b[_]=L}else{M=b[_]=pn({},_==A?V_:cA,R),M.key=_;let L=M.time,z=M.range,Z=Js(z);if((_!=A||s==2&&!L)&&(Z&&(z[0]==null||z[1]==null)&&(z={min:z[0]==null?V0:{mode:1,hard:z[0],soft:z[0]},max:z[1]==null?V0:{mode:1,hard:z[1],soft:z[1]}},Z=!1),!Z&&Cu(z))){let oe=z;z=(fe,ye,Ne)=>ye==null?Ro:bu(ye,Ne,oe)}M.range=gt(z||(L?MA:_==A?M.distr==3?wA:M.distr==4?TA:K_:M.distr==3?j_:M.distr==4?Q_:bA)),M.auto=gt(Z?!1:M.auto),M.clamp=gt(M.clamp||lA),M._min=M._max=null,M.valToPct=B(M)}}}D("x"),D("y"),s==1&&y.forEach(_=>{D(_.scale)}),C.forEach(_=>{D(_.scale)});for(let _ in n.scales)D(_);let I=b[A],k=I.distr,V,N;I.ori==0?(hi(c,U1),V=r,N=o):(hi(c,F1),V=o,N=r);let H={};for(let _ in b){let M=b[_];(M.min!=null||M.max!=null)&&(H[_]={min:M.min,max:M.max},M.min=M.max=null)}let $=n.tzDate||(_=>new Date(Mn(_/m))),G=n.fmtDate||dd,le=m==1?UT($):BT($),J=j0($,K0(m==1?DT:OT,G)),j=e_($,Q0(zT,G)),ie=[],he=i.legend=pn({},HT,n.legend),ue=i.cursor=pn({},ZT,{drag:{y:s==2}},n.cursor),Q=he.show,pe=ue.show,xe=he.markers;he.idxs=ie,xe.width=gt(xe.width),xe.dash=gt(xe.dash),xe.stroke=gt(xe.stroke),xe.fill=gt(xe.fill);let Ee,Me,He,it=[],Ve=[],ct,ot=!1,tt={};if(he.live){let _=y[1]?y[1].values:null;ot=_!=null,ct=ot?_(i,1,0):{_:0};for(let M in ct)tt[M]=ad}if(Q)if(Ee=Ui("table",q1,c),He=Ui("tbody",null,Ee),he.mount(i,Ee),ot){Me=Ui("thead",null,Ee,He);let _=Ui("tr",null,Me);Ui("th",null,_);for(var qt in ct)Ui("th",C0,_).textContent=qt}else hi(Ee,Y1),he.live&&hi(Ee,$1);let Ft={show:!0},an={show:!1};function Pt(_,M){if(M==0&&(ot||!he.live||s==2))return Ro;let R=[],L=Ui("tr",Z1,He,He.childNodes[M]);hi(L,_.class),_.show||hi(L,Tr);let z=Ui("th",null,L);if(xe.show){let fe=Mi(J1,z);if(M>0){let ye=xe.width(i,M);ye&&(fe.style.border=ye+"px "+xe.dash(i,M)+" "+xe.stroke(i,M)),fe.style.background=xe.fill(i,M)}}let Z=Mi(C0,z);_.label instanceof HTMLElement?Z.appendChild(_.label):Z.textContent=_.label,M>0&&(xe.show||(Z.style.color=_.width>0?xe.stroke(i,M):xe.fill(i,M)),xt("click",z,fe=>{if(ue._lock)return;Ze(fe);let ye=y.indexOf(_);if((fe.ctrlKey||fe.metaKey)!=he.isolate){let Ne=y.some((De,Fe)=>Fe>0&&Fe!=ye&&De.show);y.forEach((De,Fe)=>{Fe>0&&Gi(Fe,Ne?Fe==ye?Ft:an:Ft,!0,fn.setSeries)})}else Gi(ye,{show:!_.show},!0,fn.setSeries)},!1),Je&&xt(L0,z,fe=>{ue._lock||(Ze(fe),Gi(y.indexOf(_),kr,!0,fn.setSeries))},!1));for(var oe in ct){let fe=Ui("td",K1,L);fe.textContent="--",R.push(fe)}return[L,R]}let wn=new Map;function xt(_,M,R,L=!0){let z=wn.get(M)||{},Z=ue.bind[_](i,M,R,L);Z&&(Ar(_,M,z[_]=Z),wn.set(M,z))}function gn(_,M,R){let L=wn.get(M)||{};for(let z in L)(_==null||z==_)&&(Qf(z,M,L[z]),delete L[z]);_==null&&wn.delete(M)}let Kt=0,ln=0,F=0,Re=0,qe=0,st=0,be=qe,Nt=st,ze=F,Xe=Re,E=0,v=0,X=0,ce=0;i.bbox={};let re=!1,ge=!1,ve=!1,ee=!1,ne=!1,de=!1;function U(_,M,R){(R||_!=i.width||M!=i.height)&&se(_,M),at(!1),ve=!0,ge=!0,Fn()}function se(_,M){i.width=Kt=F=_,i.height=ln=Re=M,qe=st=0,Se(),Ge();let R=i.bbox;E=R.left=br(qe*bt,.5),v=R.top=br(st*bt,.5),X=R.width=br(F*bt,.5),ce=R.height=br(Re*bt,.5)}let te=3;function we(){let _=!1,M=0;for(;!_;){M++;let R=Nr(M),L=Vi(M);_=M==te||R&&L,_||(se(i.width,i.height),ge=!0)}}function me({width:_,height:M}){U(_,M)}i.setSize=me;function Se(){let _=!1,M=!1,R=!1,L=!1;C.forEach((z,Z)=>{if(z.show&&z._show){let{side:oe,_size:fe}=z,ye=oe%2,Ne=z.label!=null?z.labelSize:0,De=fe+Ne;De>0&&(ye?(F-=De,oe==3?(qe+=De,L=!0):R=!0):(Re-=De,oe==0?(st+=De,_=!0):M=!0))}}),ki[0]=_,ki[1]=R,ki[2]=M,ki[3]=L,F-=Ti[1]+Ti[3],qe+=Ti[3],Re-=Ti[2]+Ti[0],st+=Ti[0]}function Ge(){let _=qe+F,M=st+Re,R=qe,L=st;function z(Z,oe){switch(Z){case 1:return _+=oe,_-oe;case 2:return M+=oe,M-oe;case 3:return R-=oe,R+oe;case 0:return L-=oe,L+oe}}C.forEach((Z,oe)=>{if(Z.show&&Z._show){let fe=Z.side;Z._pos=z(fe,Z._size),Z.label!=null&&(Z._lpos=z(fe,Z.labelSize))}})}if(ue.dataIdx==null){let _=ue.hover,M=_.skip=new Set(_.skip??[]);M.add(void 0);let R=_.prox=gt(_.prox),L=_.bias??=0;ue.dataIdx=(z,Z,oe,fe)=>{if(Z==0)return oe;let ye=oe,Ne=R(z,Z,oe,fe)??Dt,De=Ne>=0&&Ne<Dt,Fe=I.ori==0?F:Re,nt=ue.left,Mt=e[0],yt=e[Z];if(M.has(yt[oe])){ye=null;let dt=null,Ye=null,We;if(L==0||L==-1)for(We=oe;dt==null&&We-- >0;)M.has(yt[We])||(dt=We);if(L==0||L==1)for(We=oe;Ye==null&&We++<yt.length;)M.has(yt[We])||(Ye=We);if(dt!=null||Ye!=null)if(De){let Gt=dt==null?-1/0:V(Mt[dt],I,Fe,0),en=Ye==null?1/0:V(Mt[Ye],I,Fe,0),Cn=nt-Gt,It=en-nt;Cn<=It?Cn<=Ne&&(ye=dt):It<=Ne&&(ye=Ye)}else ye=Ye==null?dt:dt==null?Ye:oe-dt<=Ye-oe?dt:Ye}else De&&bn(nt-V(Mt[oe],I,Fe,0))>Ne&&(ye=null);return ye}}let Ze=_=>{ue.event=_};ue.idxs=ie,ue._lock=!1;let ae=ue.points;ae.show=gt(ae.show),ae.size=gt(ae.size),ae.stroke=gt(ae.stroke),ae.width=gt(ae.width),ae.fill=gt(ae.fill);let Oe=i.focus=pn({},n.focus||{alpha:.3},ue.focus),Je=Oe.prox>=0,Ce=Je&&ae.one,rt=[],kt=[],Vn=[];function Oo(_,M){let R=ae.show(i,M);if(R instanceof HTMLElement)return hi(R,X1),hi(R,_.class),ts(R,-10,-10,F,Re),g.insertBefore(R,rt[M]),R}function Pr(_,M){if(s==1||M>0){let R=s==1&&b[_.scale].time,L=_.value;_.value=R?$0(L)?e_($,Q0(L,G)):L||j:L||rA,_.label=_.label||(R?KT:JT)}if(Ce||M>0){_.width=_.width==null?1:_.width,_.paths=_.paths||vA||cT,_.fillTo=gt(_.fillTo||uA),_.pxAlign=+St(_.pxAlign,S),_.pxRound=c_(_.pxAlign),_.stroke=gt(_.stroke||null),_.fill=gt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let R=oA(Jn(1,_.width),1),L=_.points=pn({},{size:R,width:Jn(1,R*.2),stroke:_.stroke,space:R*2,paths:yA,_stroke:null,_fill:null},_.points);L.show=gt(L.show),L.filter=gt(L.filter),L.fill=gt(L.fill),L.stroke=gt(L.stroke),L.paths=gt(L.paths),L.pxAlign=_.pxAlign}if(Q){let R=Pt(_,M);it.splice(M,0,R[0]),Ve.splice(M,0,R[1]),he.values.push(null)}if(pe){ie.splice(M,0,null);let R=null;Ce?M==0&&(R=Oo(_,M)):M>0&&(R=Oo(_,M)),rt.splice(M,0,R),kt.splice(M,0,0),Vn.splice(M,0,0)}En("addSeries",M)}function Fu(_,M){M=M??y.length,_=s==1?rd(_,M,n_,a_):rd(_,M,{},o_),y.splice(M,0,_),Pr(y[M],M)}i.addSeries=Fu;function il(_){if(y.splice(_,1),Q){he.values.splice(_,1),Ve.splice(_,1);let M=it.splice(_,1)[0];gn(null,M.firstChild),M.remove()}pe&&(ie.splice(_,1),rt.splice(_,1)[0].remove(),kt.splice(_,1),Vn.splice(_,1)),En("delSeries",_)}i.delSeries=il;let ki=[!1,!1,!1,!1];function is(_,M){if(_._show=_.show,_.show){let R=_.side%2,L=b[_.scale];L==null&&(_.scale=R?y[1].scale:A,L=b[_.scale]);let z=L.time;_.size=gt(_.size),_.space=gt(_.space),_.rotate=gt(_.rotate),Js(_.incrs)&&_.incrs.forEach(oe=>{!Ks.has(oe)&&Ks.set(oe,M_(oe))}),_.incrs=gt(_.incrs||(L.distr==2?IT:z?m==1?NT:FT:wr)),_.splits=gt(_.splits||(z&&L.distr==1?le:L.distr==3?td:L.distr==4?eA:QT)),_.stroke=gt(_.stroke),_.grid.stroke=gt(_.grid.stroke),_.ticks.stroke=gt(_.ticks.stroke),_.border.stroke=gt(_.border.stroke);let Z=_.values;_.values=Js(Z)&&!Js(Z[0])?gt(Z):z?Js(Z)?j0($,K0(Z,G)):$0(Z)?kT($,Z):Z||J:Z||jT,_.filter=gt(_.filter||(L.distr>=3&&L.log==10?iA:L.distr==3&&L.log==2?sA:y_)),_.font=d_(_.font),_.labelFont=d_(_.labelFont),_._size=_.size(i,null,M,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(ki[M]=!0,_._el=Mi(V1,f))}}function ss(_,M,R,L){let[z,Z,oe,fe]=R,ye=M%2,Ne=0;return ye==0&&(fe||Z)&&(Ne=M==0&&!z||M==2&&!oe?Mn(t_.size/3):0),ye==1&&(z||oe)&&(Ne=M==1&&!Z||M==3&&!fe?Mn(s_.size/2):0),Ne}let Bo=i.padding=(n.padding||[ss,ss,ss,ss]).map(_=>gt(St(_,ss))),Ti=i._padding=Bo.map((_,M)=>_(i,M,ki,0)),jt,sn=null,rn=null,zi=s==1?y[0].idxs:null,ni=null,Es=!1;function ko(_,M){if(e=_??[],i.data=i._data=e,s==2){jt=0;for(let R=1;R<y.length;R++)jt+=e[R][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),ni=e[0],jt=ni.length;let R=e;if(k==2){R=e.slice();let L=R[0]=Array(jt);for(let z=0;z<jt;z++)L[z]=z}i._data=e=R}if(at(!0),En("setData"),k==2&&(ve=!0),M!==!1){let R=I;R.auto(i,Es)?zo():Ps(A,R.min,R.max),ee=ee||ue.left>=0,de=!0,Fn()}}i.setData=ko;function zo(){Es=!0;let _,M;s==1&&(jt>0?(sn=zi[0]=0,rn=zi[1]=jt-1,_=e[0][sn],M=e[0][rn],k==2?(_=sn,M=rn):_==M&&(k==3?[_,M]=Au(_,_,I.log,!1):k==4?[_,M]=cd(_,_,I.log,!1):I.time?M=_+Mn(86400/m):[_,M]=bu(_,M,ud,!0))):(sn=zi[0]=_=null,rn=zi[1]=M=null)),Ps(A,_,M)}let Ir,Cs,Lr,w,O,K,q,Y,Te,Pe;function Ae(_,M,R,L,z,Z){_??=P0,R??=fd,L??="butt",z??=P0,Z??="round",_!=Ir&&(h.strokeStyle=Ir=_),z!=Cs&&(h.fillStyle=Cs=z),M!=Lr&&(h.lineWidth=Lr=M),Z!=O&&(h.lineJoin=O=Z),L!=K&&(h.lineCap=K=L),R!=w&&h.setLineDash(w=R)}function Ie(_,M,R,L){M!=Cs&&(h.fillStyle=Cs=M),_!=q&&(h.font=q=_),R!=Y&&(h.textAlign=Y=R),L!=Te&&(h.textBaseline=Te=L)}function ke(_,M,R,L,z=0){if(L.length>0&&_.auto(i,Es)&&(M==null||M.min==null)){let Z=St(sn,0),oe=St(rn,L.length-1),fe=R.min==null?iT(L,Z,oe,z,_.distr==3):[R.min,R.max];_.min=Oi(_.min,R.min=fe[0]),_.max=Jn(_.max,R.max=fe[1])}}let Qe={min:null,max:null};function ut(){for(let L in b){let z=b[L];H[L]==null&&(z.min==null||H[A]!=null&&z.auto(i,Es))&&(H[L]=Qe)}for(let L in b){let z=b[L];H[L]==null&&z.from!=null&&H[z.from]!=null&&(H[L]=Qe)}H[A]!=null&&at(!0);let _={};for(let L in H){let z=H[L];if(z!=null){let Z=_[L]=Po(b[L],fT);if(z.min!=null)pn(Z,z);else if(L!=A||s==2)if(jt==0&&Z.from==null){let oe=Z.range(i,null,null,L);Z.min=oe[0],Z.max=oe[1]}else Z.min=Dt,Z.max=-Dt}}if(jt>0){y.forEach((L,z)=>{if(s==1){let Z=L.scale,oe=H[Z];if(oe==null)return;let fe=_[Z];if(z==0){let ye=fe.range(i,fe.min,fe.max,Z);fe.min=ye[0],fe.max=ye[1],sn=Fi(fe.min,e[0]),rn=Fi(fe.max,e[0]),rn-sn>1&&(e[0][sn]<fe.min&&sn++,e[0][rn]>fe.max&&rn--),L.min=ni[sn],L.max=ni[rn]}else L.show&&L.auto&&ke(fe,oe,L,e[z],L.sorted);L.idxs[0]=sn,L.idxs[1]=rn}else if(z>0&&L.show&&L.auto){let[Z,oe]=L.facets,fe=Z.scale,ye=oe.scale,[Ne,De]=e[z],Fe=_[fe],nt=_[ye];Fe!=null&&ke(Fe,H[fe],Z,Ne,Z.sorted),nt!=null&&ke(nt,H[ye],oe,De,oe.sorted),L.min=oe.min,L.max=oe.max}});for(let L in _){let z=_[L],Z=H[L];if(z.from==null&&(Z==null||Z.min==null)){let oe=z.range(i,z.min==Dt?null:z.min,z.max==-Dt?null:z.max,L);z.min=oe[0],z.max=oe[1]}}}for(let L in _){let z=_[L];if(z.from!=null){let Z=_[z.from];if(Z.min==null)z.min=z.max=null;else{let oe=z.range(i,Z.min,Z.max,L);z.min=oe[0],z.max=oe[1]}}}let M={},R=!1;for(let L in _){let z=_[L],Z=b[L];if(Z.min!=z.min||Z.max!=z.max){Z.min=z.min,Z.max=z.max;let oe=Z.distr;Z._min=oe==3?Ts(Z.min):oe==4?qf(Z.min,Z.asinh):oe==100?Z.fwd(Z.min):Z.min,Z._max=oe==3?Ts(Z.max):oe==4?qf(Z.max,Z.asinh):oe==100?Z.fwd(Z.max):Z.max,M[L]=R=!0}}if(R){y.forEach((L,z)=>{s==2?z>0&&M.y&&(L._paths=null):M[L.scale]&&(L._paths=null)});for(let L in M)ve=!0,En("setScale",L);pe&&ue.left>=0&&(ee=de=!0)}for(let L in H)H[L]=null}function Be(_){let M=ed(sn-1,0,jt-1),R=ed(rn+1,0,jt-1);for(;_[M]==null&&M>0;)M--;for(;_[R]==null&&R<jt-1;)R++;return[M,R]}function ht(){if(jt>0){let _=y.some(M=>M._focus)&&Pe!=Oe.alpha;_&&(h.globalAlpha=Pe=Oe.alpha),y.forEach((M,R)=>{if(R>0&&M.show&&(Zt(R,!1),Zt(R,!0),M._paths==null)){let L=Pe;Pe!=M.alpha&&(h.globalAlpha=Pe=M.alpha);let z=s==2?[0,e[R][0].length-1]:Be(e[R]);M._paths=M.paths(i,R,z[0],z[1]),Pe!=L&&(h.globalAlpha=Pe=L)}}),y.forEach((M,R)=>{if(R>0&&M.show){let L=Pe;Pe!=M.alpha&&(h.globalAlpha=Pe=M.alpha),M._paths!=null&&Et(R,!1);{let z=M._paths!=null?M._paths.gaps:null,Z=M.points.show(i,R,sn,rn,z),oe=M.points.filter(i,R,Z,z);(Z||oe)&&(M.points._paths=M.points.paths(i,R,sn,rn,oe),Et(R,!0))}Pe!=L&&(h.globalAlpha=Pe=L),En("drawSeries",R)}}),_&&(h.globalAlpha=Pe=1)}}function Zt(_,M){let R=M?y[_].points:y[_];R._stroke=R.stroke(i,_),R._fill=R.fill(i,_)}function Et(_,M){let R=M?y[_].points:y[_],{stroke:L,fill:z,clip:Z,flags:oe,_stroke:fe=R._stroke,_fill:ye=R._fill,_width:Ne=R.width}=R._paths;Ne=Ut(Ne*bt,3);let De=null,Fe=Ne%2/2;M&&ye==null&&(ye=Ne>0?"#fff":fe);let nt=R.pxAlign==1&&Fe>0;if(nt&&h.translate(Fe,Fe),!M){let Mt=E-Ne/2,yt=v-Ne/2,dt=X+Ne,Ye=ce+Ne;De=new Path2D,De.rect(Mt,yt,dt,Ye)}M?Ue(fe,Ne,R.dash,R.cap,ye,L,z,oe,Z):Ct(_,fe,Ne,R.dash,R.cap,ye,L,z,oe,De,Z),nt&&h.translate(-Fe,-Fe)}function Ct(_,M,R,L,z,Z,oe,fe,ye,Ne,De){let Fe=!1;ye!=0&&P.forEach((nt,Mt)=>{if(nt.series[0]==_){let yt=y[nt.series[1]],dt=e[nt.series[1]],Ye=(yt._paths||ja).band;Js(Ye)&&(Ye=nt.dir==1?Ye[0]:Ye[1]);let We,Gt=null;yt.show&&Ye&&rT(dt,sn,rn)?(Gt=nt.fill(i,Mt)||Z,We=yt._paths.clip):Ye=null,Ue(M,R,L,z,Gt,oe,fe,ye,Ne,De,We,Ye),Fe=!0}}),Fe||Ue(M,R,L,z,Z,oe,fe,ye,Ne,De)}let _n=Io|id;function Ue(_,M,R,L,z,Z,oe,fe,ye,Ne,De,Fe){Ae(_,M,R,L,z),(ye||Ne||Fe)&&(h.save(),ye&&h.clip(ye),Ne&&h.clip(Ne)),Fe?(fe&_n)==_n?(h.clip(Fe),De&&h.clip(De),pt(z,oe),cn(_,Z,M)):fe&id?(pt(z,oe),h.clip(Fe),cn(_,Z,M)):fe&Io&&(h.save(),h.clip(Fe),De&&h.clip(De),pt(z,oe),h.restore(),cn(_,Z,M)):(pt(z,oe),cn(_,Z,M)),(ye||Ne||Fe)&&h.restore()}function cn(_,M,R){R>0&&(M instanceof Map?M.forEach((L,z)=>{h.strokeStyle=Ir=z,h.stroke(L)}):M!=null&&_&&h.stroke(M))}function pt(_,M){M instanceof Map?M.forEach((R,L)=>{h.fillStyle=Cs=L,h.fill(R)}):M!=null&&_&&h.fill(M)}function rs(_,M,R,L){let z=C[_],Z;if(L<=0)Z=[0,0];else{let oe=z._space=z.space(i,_,M,R,L),fe=z._incrs=z.incrs(i,_,M,R,L,oe);Z=AA(M,R,fe,L,oe)}return z._found=Z}function un(_,M,R,L,z,Z,oe,fe,ye,Ne){let De=oe%2/2;S==1&&h.translate(De,De),Ae(fe,oe,ye,Ne,fe),h.beginPath();let Fe,nt,Mt,yt,dt=z+(L==0||L==3?-Z:Z);R==0?(nt=z,yt=dt):(Fe=z,Mt=dt);for(let Ye=0;Ye<_.length;Ye++)M[Ye]!=null&&(R==0?Fe=Mt=_[Ye]:nt=yt=_[Ye],h.moveTo(Fe,nt),h.lineTo(Mt,yt));h.stroke(),S==1&&h.translate(-De,-De)}function Nr(_){let M=!0;return C.forEach((R,L)=>{if(!R.show)return;let z=b[R.scale];if(z.min==null){R._show&&(M=!1,R._show=!1,at(!1));return}else R._show||(M=!1,R._show=!0,at(!1));let Z=R.side,oe=Z%2,{min:fe,max:ye}=z,[Ne,De]=rs(L,fe,ye,oe==0?F:Re);if(De==0)return;let Fe=z.distr==2,nt=R._splits=R.splits(i,L,fe,ye,Ne,De,Fe),Mt=z.distr==2?nt.map(We=>ni[We]):nt,yt=z.distr==2?ni[nt[1]]-ni[nt[0]]:Ne,dt=R._values=R.values(i,R.filter(i,Mt,L,De,yt),L,De,yt);R._rotate=Z==2?R.rotate(i,dt,L,De):0;let Ye=R._size;R._size=bi(R.size(i,dt,L,_)),Ye!=null&&R._size!=Ye&&(M=!1)}),M}function Vi(_){let M=!0;return Bo.forEach((R,L)=>{let z=R(i,L,ki,_);z!=Ti[L]&&(M=!1),Ti[L]=z}),M}function os(){for(let _=0;_<C.length;_++){let M=C[_];if(!M.show||!M._show)continue;let R=M.side,L=R%2,z,Z,oe=M.stroke(i,_),fe=R==0||R==3?-1:1,[ye,Ne]=M._found;if(M.label!=null){let Wn=M.labelGap*fe,ri=Mn((M._lpos+Wn)*bt);Ie(M.labelFont[0],oe,"center",R==2?"top":R0),h.save(),L==1?(z=Z=0,h.translate(ri,Mn(v+ce/2)),h.rotate((R==3?-Su:Su)/2)):(z=Mn(E+X/2),Z=ri);let tr=x_(M.label)?M.label(i,_,ye,Ne):M.label;h.fillText(tr,z,Z),h.restore()}if(Ne==0)continue;let De=b[M.scale],Fe=L==0?X:ce,nt=L==0?E:v,Mt=M._splits,yt=De.distr==2?Mt.map(Wn=>ni[Wn]):Mt,dt=De.distr==2?ni[Mt[1]]-ni[Mt[0]]:ye,Ye=M.ticks,We=M.border,Gt=Ye.show?Ye.size:0,en=Mn(Gt*bt),Cn=Mn((M.alignTo==2?M._size-Gt-M.gap:M.gap)*bt),It=M._rotate*-Su/180,tn=d(M._pos*bt),ii=(en+Cn)*fe,Hn=tn+ii;Z=L==0?Hn:0,z=L==1?Hn:0;let mi=M.font[0],Ai=M.align==1?To:M.align==2?Hf:It>0?To:It<0?Hf:L==0?"center":R==3?Hf:To,Wi=It||L==1?"middle":R==2?"top":R0;Ie(mi,oe,Ai,Wi);let si=M.font[1]*M.lineGap,gi=Mt.map(Wn=>d(a(Wn,De,Fe,nt))),Ei=M._values;for(let Wn=0;Wn<Ei.length;Wn++){let ri=Ei[Wn];if(ri!=null){L==0?z=gi[Wn]:Z=gi[Wn],ri=""+ri;let tr=ri.indexOf(`
`)==-1?[ri]:ri.split(/\n/gm);for(let Xn=0;Xn<tr.length;Xn++){let Xd=tr[Xn];It?(h.save(),h.translate(z,Z+Xn*si),h.rotate(It),h.fillText(Xd,0,0),h.restore()):h.fillText(Xd,z,Z+Xn*si)}}}Ye.show&&un(gi,Ye.filter(i,yt,_,Ne,dt),L,R,tn,en,Ut(Ye.width*bt,3),Ye.stroke(i,_),Ye.dash,Ye.cap);let Xi=M.grid;Xi.show&&un(gi,Xi.filter(i,yt,_,Ne,dt),L,L==0?2:1,L==0?v:E,L==0?ce:X,Ut(Xi.width*bt,3),Xi.stroke(i,_),Xi.dash,Xi.cap),We.show&&un([tn],[1],L==0?1:0,L==0?1:2,L==1?v:E,L==1?ce:X,Ut(We.width*bt,3),We.stroke(i,_),We.dash,We.cap)}En("drawAxes")}function at(_){y.forEach((M,R)=>{R>0&&(M._paths=null,_&&(s==1?(M.min=null,M.max=null):M.facets.forEach(L=>{L.min=null,L.max=null})))})}let Qt=!1,Gn=!1,Rt=[];function hn(){Gn=!1;for(let _=0;_<Rt.length;_++)En(...Rt[_]);Rt.length=0}function Fn(){Qt||(vT(Ed),Qt=!0)}function sl(_,M=!1){Qt=!0,Gn=M,_(i),Ed(),M&&Rt.length>0&&queueMicrotask(hn)}i.batch=sl;function Ed(){if(re&&(ut(),re=!1),ve&&(we(),ve=!1),ge){if(Xt(p,To,qe),Xt(p,"top",st),Xt(p,Ya,F),Xt(p,Za,Re),Xt(g,To,qe),Xt(g,"top",st),Xt(g,Ya,F),Xt(g,Za,Re),Xt(f,Ya,Kt),Xt(f,Za,ln),u.width=Mn(Kt*bt),u.height=Mn(ln*bt),C.forEach(({_el:_,_show:M,_size:R,_pos:L,side:z})=>{if(_!=null)if(M){let Z=z===3||z===0?R:0,oe=z%2==1;Xt(_,oe?"left":"top",L-Z),Xt(_,oe?"width":"height",R),Xt(_,oe?"top":"left",oe?st:qe),Xt(_,oe?"height":"width",oe?Re:F),jf(_,Tr)}else hi(_,Tr)}),Ir=Cs=Lr=O=K=q=Y=Te=w=null,Pe=1,Ho(!0),qe!=be||st!=Nt||F!=ze||Re!=Xe){at(!1);let _=F/ze,M=Re/Xe;if(pe&&!ee&&ue.left>=0){ue.left*=_,ue.top*=M,Dr&&ts(Dr,Mn(ue.left),0,F,Re),Ur&&ts(Ur,0,Mn(ue.top),F,Re);for(let R=0;R<rt.length;R++){let L=rt[R];L!=null&&(kt[R]*=_,Vn[R]*=M,ts(L,bi(kt[R]),bi(Vn[R]),F,Re))}}if(Vt.show&&!ne&&Vt.left>=0&&Vt.width>0){Vt.left*=_,Vt.width*=_,Vt.top*=M,Vt.height*=M;for(let R in Gu)Xt(Br,R,Vt[R])}be=qe,Nt=st,ze=F,Xe=Re}En("setSize"),ge=!1}Kt>0&&ln>0&&(h.clearRect(0,0,u.width,u.height),En("drawClear"),T.forEach(_=>_()),En("draw")),Vt.show&&ne&&(rl(Vt),ne=!1),pe&&ee&&(er(null,!0,!1),ee=!1),he.show&&he.live&&de&&(zu(),de=!1),l||(l=!0,i.status=1,En("ready")),Es=!1,Qt=!1}i.redraw=(_,M)=>{ve=M||!1,_!==!1?Ps(A,I.min,I.max):Fn()};function Ou(_,M){let R=b[_];if(R.from==null){if(jt==0){let L=R.range(i,M.min,M.max,_);M.min=L[0],M.max=L[1]}if(M.min>M.max){let L=M.min;M.min=M.max,M.max=L}if(jt>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;_==A&&R.distr==2&&jt>0&&(M.min=Fi(M.min,e[0]),M.max=Fi(M.max,e[0]),M.min==M.max&&M.max++),H[_]=M,re=!0,Fn()}}i.setScale=Ou;let Bu,ku,Dr,Ur,Cd,Rd,Fr,Or,Pd,Id,zt,$t,Rs=!1,In=ue.drag,Tn=In.x,An=In.y;pe&&(ue.x&&(Bu=Mi(H1,g)),ue.y&&(ku=Mi(W1,g)),I.ori==0?(Dr=Bu,Ur=ku):(Dr=ku,Ur=Bu),zt=ue.left,$t=ue.top);let Vt=i.select=pn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Br=Vt.show?Mi(G1,Vt.over?g:p):null;function rl(_,M){if(Vt.show){for(let R in _)Vt[R]=_[R],R in Gu&&Xt(Br,R,_[R]);M!==!1&&En("setSelect")}}i.setSelect=rl;function qx(_){if(y[_].show)Q&&jf(it[_],Tr);else if(Q&&hi(it[_],Tr),pe){let R=Ce?rt[0]:rt[_];R!=null&&ts(R,-10,-10,F,Re)}}function Ps(_,M,R){Ou(_,{min:M,max:R})}function Gi(_,M,R,L){M.focus!=null&&Kx(_),M.show!=null&&y.forEach((z,Z)=>{Z>0&&(_==Z||_==null)&&(z.show=M.show,qx(Z),s==2?(Ps(z.facets[0].scale,null,null),Ps(z.facets[1].scale,null,null)):Ps(z.scale,null,null),Fn())}),R!==!1&&En("setSeries",_,M),L&&Wo("setSeries",i,_,M)}i.setSeries=Gi;function $x(_,M){pn(P[_],M)}function Yx(_,M){_.fill=gt(_.fill||null),_.dir=St(_.dir,-1),M=M??P.length,P.splice(M,0,_)}function Zx(_){_==null?P.length=0:P.splice(_,1)}i.addBand=Yx,i.setBand=$x,i.delBand=Zx;function Jx(_,M){y[_].alpha=M,pe&&rt[_]!=null&&(rt[_].style.opacity=M),Q&&it[_]&&(it[_].style.opacity=M)}let as,Is,Qs,kr={focus:!0};function Kx(_){if(_!=Qs){let M=_==null,R=Oe.alpha!=1;y.forEach((L,z)=>{if(s==1||z>0){let Z=M||z==0||z==_;L._focus=M?null:Z,R&&Jx(z,Z?1:Oe.alpha)}}),Qs=_,R&&Fn()}}Q&&Je&&xt(N0,Ee,_=>{ue._lock||(Ze(_),Qs!=null&&Gi(null,kr,!0,fn.setSeries))});function Hi(_,M,R){let L=b[M];R&&(_=_/bt-(L.ori==1?st:qe));let z=F;L.ori==1&&(z=Re,_=z-_),L.dir==-1&&(_=z-_);let Z=L._min,oe=L._max,fe=_/z,ye=Z+(oe-Z)*fe,Ne=L.distr;return Ne==3?Co(10,ye):Ne==4?aT(ye,L.asinh):Ne==100?L.bwd(ye):ye}function jx(_,M){let R=Hi(_,A,M);return Fi(R,e[0],sn,rn)}i.valToIdx=_=>Fi(_,e[0]),i.posToIdx=jx,i.posToVal=Hi,i.valToPos=(_,M,R)=>b[M].ori==0?r(_,b[M],R?X:F,R?E:0):o(_,b[M],R?ce:Re,R?v:0),i.setCursor=(_,M,R)=>{zt=_.left,$t=_.top,er(null,M,R)};function Ld(_,M){Xt(Br,To,Vt.left=_),Xt(Br,Ya,Vt.width=M)}function Nd(_,M){Xt(Br,"top",Vt.top=_),Xt(Br,Za,Vt.height=M)}let Vo=I.ori==0?Ld:Nd,Go=I.ori==1?Ld:Nd;function Qx(){if(Q&&he.live)for(let _=s==2?1:0;_<y.length;_++){if(_==0&&ot)continue;let M=he.values[_],R=0;for(let L in M)Ve[_][R++].firstChild.nodeValue=M[L]}}function zu(_,M){if(_!=null&&(_.idxs?_.idxs.forEach((R,L)=>{ie[L]=R}):hT(_.idx)||ie.fill(_.idx),he.idx=ie[0]),Q&&he.live){for(let R=0;R<y.length;R++)(R>0||s==1&&!ot)&&ev(R,ie[R]);Qx()}de=!1,M!==!1&&En("setLegend")}i.setLegend=zu;function ev(_,M){let R=y[_],L=_==0&&k==2?ni:e[_],z;ot?z=R.values(i,_,M)??tt:(z=R.value(i,M==null?null:L[M],_,M),z=z==null?tt:{_:z}),he.values[_]=z}function er(_,M,R){Pd=zt,Id=$t,[zt,$t]=ue.move(i,zt,$t),ue.left=zt,ue.top=$t,pe&&(Dr&&ts(Dr,Mn(zt),0,F,Re),Ur&&ts(Ur,0,Mn($t),F,Re));let L,z=sn>rn;as=Dt,Is=null;let Z=I.ori==0?F:Re,oe=I.ori==1?F:Re;if(zt<0||jt==0||z){L=ue.idx=null;for(let fe=0;fe<y.length;fe++){let ye=rt[fe];ye!=null&&ts(ye,-10,-10,F,Re)}Je&&Gi(null,kr,!0,_==null&&fn.setSeries),he.live&&(ie.fill(L),de=!0)}else{let fe,ye,Ne;s==1&&(fe=I.ori==0?zt:$t,ye=Hi(fe,A),L=ue.idx=Fi(ye,e[0],sn,rn),Ne=V(e[0][L],I,Z,0));let De=-10,Fe=-10,nt=0,Mt=0,yt=!0,dt="",Ye="";for(let We=s==2?1:0;We<y.length;We++){let Gt=y[We],en=ie[We],Cn=en==null?null:s==1?e[We][en]:e[We][1][en],It=ue.dataIdx(i,We,L,ye),tn=It==null?null:s==1?e[We][It]:e[We][1][It];if(de=de||tn!=Cn||It!=en,ie[We]=It,We>0&&Gt.show){let ii=It==null?-10:It==L?Ne:V(s==1?e[0][It]:e[We][0][It],I,Z,0),Hn=tn==null?-10:N(tn,s==1?b[Gt.scale]:b[Gt.facets[1].scale],oe,0);if(Je&&tn!=null){let mi=I.ori==1?zt:$t,Ai=bn(Oe.dist(i,We,It,Hn,mi));if(Ai<as){let Wi=Oe.bias;if(Wi!=0){let si=Hi(mi,Gt.scale),gi=tn>=0?1:-1,Ei=si>=0?1:-1;Ei==gi&&(Ei==1?Wi==1?tn>=si:tn<=si:Wi==1?tn<=si:tn>=si)&&(as=Ai,Is=We)}else as=Ai,Is=We}}if(de||Ce){let mi,Ai;I.ori==0?(mi=ii,Ai=Hn):(mi=Hn,Ai=ii);let Wi,si,gi,Ei,Xi,Wn,ri=!0,tr=ae.bbox;if(tr!=null){ri=!1;let Xn=tr(i,We);gi=Xn.left,Ei=Xn.top,Wi=Xn.width,si=Xn.height}else gi=mi,Ei=Ai,Wi=si=ae.size(i,We);if(Wn=ae.fill(i,We),Xi=ae.stroke(i,We),Ce)We==Is&&as<=Oe.prox&&(De=gi,Fe=Ei,nt=Wi,Mt=si,yt=ri,dt=Wn,Ye=Xi);else{let Xn=rt[We];Xn!=null&&(kt[We]=gi,Vn[We]=Ei,z0(Xn,Wi,si,ri),B0(Xn,Wn,Xi),ts(Xn,bi(gi),bi(Ei),F,Re))}}}}if(Ce){let We=Oe.prox,Gt=Qs==null?as<=We:as>We||Is!=Qs;if(de||Gt){let en=rt[0];en!=null&&(kt[0]=De,Vn[0]=Fe,z0(en,nt,Mt,yt),B0(en,dt,Ye),ts(en,bi(De),bi(Fe),F,Re))}}}if(Vt.show&&Rs)if(_!=null){let[fe,ye]=fn.scales,[Ne,De]=fn.match,[Fe,nt]=_.cursor.sync.scales,Mt=_.cursor.drag;if(Tn=Mt._x,An=Mt._y,Tn||An){let{left:yt,top:dt,width:Ye,height:We}=_.select,Gt=_.scales[Fe].ori,en=_.posToVal,Cn,It,tn,ii,Hn,mi=fe!=null&&Ne(fe,Fe),Ai=ye!=null&&De(ye,nt);mi&&Tn?(Gt==0?(Cn=yt,It=Ye):(Cn=dt,It=We),tn=b[fe],ii=V(en(Cn,Fe),tn,Z,0),Hn=V(en(Cn+It,Fe),tn,Z,0),Vo(Oi(ii,Hn),bn(Hn-ii))):Vo(0,Z),Ai&&An?(Gt==1?(Cn=yt,It=Ye):(Cn=dt,It=We),tn=b[ye],ii=N(en(Cn,nt),tn,oe,0),Hn=N(en(Cn+It,nt),tn,oe,0),Go(Oi(ii,Hn),bn(Hn-ii))):Go(0,oe)}else Hu()}else{let fe=bn(Pd-Cd),ye=bn(Id-Rd);if(I.ori==1){let nt=fe;fe=ye,ye=nt}Tn=In.x&&fe>=In.dist,An=In.y&&ye>=In.dist;let Ne=In.uni;Ne!=null?Tn&&An&&(Tn=fe>=Ne,An=ye>=Ne,!Tn&&!An&&(ye>fe?An=!0:Tn=!0)):In.x&&In.y&&(Tn||An)&&(Tn=An=!0);let De,Fe;Tn&&(I.ori==0?(De=Fr,Fe=zt):(De=Or,Fe=$t),Vo(Oi(De,Fe),bn(Fe-De)),An||Go(0,oe)),An&&(I.ori==1?(De=Fr,Fe=zt):(De=Or,Fe=$t),Go(Oi(De,Fe),bn(Fe-De)),Tn||Vo(0,Z)),!Tn&&!An&&(Vo(0,0),Go(0,0))}if(In._x=Tn,In._y=An,_==null){if(R){if(Wd!=null){let[fe,ye]=fn.scales;fn.values[0]=fe!=null?Hi(I.ori==0?zt:$t,fe):null,fn.values[1]=ye!=null?Hi(I.ori==1?zt:$t,ye):null}Wo(Wf,i,zt,$t,F,Re,L)}if(Je){let fe=R&&fn.setSeries,ye=Oe.prox;Qs==null?as<=ye&&Gi(Is,kr,!0,fe):as>ye?Gi(null,kr,!0,fe):Is!=Qs&&Gi(Is,kr,!0,fe)}}de&&(he.idx=L,zu()),M!==!1&&En("setCursor")}let Ls=null;Object.defineProperty(i,"rect",{get(){return Ls==null&&Ho(!1),Ls}});function Ho(_=!1){_?Ls=null:(Ls=g.getBoundingClientRect(),En("syncRect",Ls))}function Dd(_,M,R,L,z,Z,oe){ue._lock||Rs&&_!=null&&_.movementX==0&&_.movementY==0||(Vu(_,M,R,L,z,Z,oe,!1,_!=null),_!=null?er(null,!0,!0):er(M,!0,!1))}function Vu(_,M,R,L,z,Z,oe,fe,ye){if(Ls==null&&Ho(!1),Ze(_),_!=null)R=_.clientX-Ls.left,L=_.clientY-Ls.top;else{if(R<0||L<0){zt=-10,$t=-10;return}let[Ne,De]=fn.scales,Fe=M.cursor.sync,[nt,Mt]=Fe.values,[yt,dt]=Fe.scales,[Ye,We]=fn.match,Gt=M.axes[0].side%2==1,en=I.ori==0?F:Re,Cn=I.ori==1?F:Re,It=Gt?Z:z,tn=Gt?z:Z,ii=Gt?L:R,Hn=Gt?R:L;if(yt!=null?R=Ye(Ne,yt)?a(nt,b[Ne],en,0):-10:R=en*(ii/It),dt!=null?L=We(De,dt)?a(Mt,b[De],Cn,0):-10:L=Cn*(Hn/tn),I.ori==1){let mi=R;R=L,L=mi}}ye&&(M==null||M.cursor.event.type==Wf)&&((R<=1||R>=F-1)&&(R=br(R,F)),(L<=1||L>=Re-1)&&(L=br(L,Re))),fe?(Cd=R,Rd=L,[Fr,Or]=ue.move(i,R,L)):(zt=R,$t=L)}let Gu={width:0,height:0,left:0,top:0};function Hu(){rl(Gu,!1)}let Ud,Fd,Od,Bd;function kd(_,M,R,L,z,Z,oe){Rs=!0,Tn=An=In._x=In._y=!1,Vu(_,M,R,L,z,Z,oe,!0,!1),_!=null&&(xt(Xf,Jf,zd,!1),Wo(I0,i,Fr,Or,F,Re,null));let{left:fe,top:ye,width:Ne,height:De}=Vt;Ud=fe,Fd=ye,Od=Ne,Bd=De}function zd(_,M,R,L,z,Z,oe){Rs=In._x=In._y=!1,Vu(_,M,R,L,z,Z,oe,!1,!0);let{left:fe,top:ye,width:Ne,height:De}=Vt,Fe=Ne>0||De>0,nt=Ud!=fe||Fd!=ye||Od!=Ne||Bd!=De;if(Fe&&nt&&rl(Vt),In.setScale&&Fe&&nt){let Mt=fe,yt=Ne,dt=ye,Ye=De;if(I.ori==1&&(Mt=ye,yt=De,dt=fe,Ye=Ne),Tn&&Ps(A,Hi(Mt,A),Hi(Mt+yt,A)),An)for(let We in b){let Gt=b[We];We!=A&&Gt.from==null&&Gt.min!=Dt&&Ps(We,Hi(dt+Ye,We),Hi(dt,We))}Hu()}else ue.lock&&(ue._lock=!ue._lock,er(M,!0,_!=null));_!=null&&(gn(Xf,Jf),Wo(Xf,i,zt,$t,F,Re,null))}function tv(_,M,R,L,z,Z,oe){if(ue._lock)return;Ze(_);let fe=Rs;if(Rs){let ye=!0,Ne=!0,De=10,Fe,nt;I.ori==0?(Fe=Tn,nt=An):(Fe=An,nt=Tn),Fe&&nt&&(ye=zt<=De||zt>=F-De,Ne=$t<=De||$t>=Re-De),Fe&&ye&&(zt=zt<Fr?0:F),nt&&Ne&&($t=$t<Or?0:Re),er(null,!0,!0),Rs=!1}zt=-10,$t=-10,ie.fill(null),er(null,!0,!0),fe&&(Rs=fe)}function Vd(_,M,R,L,z,Z,oe){ue._lock||(Ze(_),zo(),Hu(),_!=null&&Wo(D0,i,zt,$t,F,Re,null))}function Gd(){C.forEach(EA),U(i.width,i.height,!0)}Ar(Mu,Eo,Gd);let zr={};zr.mousedown=kd,zr.mousemove=Dd,zr.mouseup=zd,zr.dblclick=Vd,zr.setSeries=(_,M,R,L)=>{let z=fn.match[2];R=z(i,M,R),R!=-1&&Gi(R,L,!0,!1)},pe&&(xt(I0,g,kd),xt(Wf,g,Dd),xt(L0,g,_=>{Ze(_),Ho(!1)}),xt(N0,g,tv),xt(D0,g,Vd),sd.add(i),i.syncRect=Ho);let ol=i.hooks=n.hooks||{};function En(_,M,R){Gn?Rt.push([_,M,R]):_ in ol&&ol[_].forEach(L=>{L.call(null,i,M,R)})}(n.plugins||[]).forEach(_=>{for(let M in _.hooks)ol[M]=(ol[M]||[]).concat(_.hooks[M])});let Hd=(_,M,R)=>R,fn=pn({key:null,setSeries:!1,filters:{pub:X0,sub:X0},scales:[A,y[1]?y[1].scale:null],match:[q0,q0,Hd],values:[null,null]},ue.sync);fn.match.length==2&&fn.match.push(Hd),ue.sync=fn;let Wd=fn.key,Wu=G_(Wd);function Wo(_,M,R,L,z,Z,oe){fn.filters.pub(_,M,R,L,z,Z,oe)&&Wu.pub(_,M,R,L,z,Z,oe)}Wu.sub(i);function nv(_,M,R,L,z,Z,oe){fn.filters.sub(_,M,R,L,z,Z,oe)&&zr[_](null,M,R,L,z,Z,oe)}i.pub=nv;function iv(){Wu.unsub(i),sd.delete(i),wn.clear(),Qf(Mu,Eo,Gd),c.remove(),Ee?.remove(),En("destroy")}i.destroy=iv;function Xu(){En("init",n,e),ko(e||n.data,!1),H[A]?Ou(A,H[A]):zo(),ne=Vt.show&&(Vt.width>0||Vt.height>0),ee=de=!0,U(n.width,n.height)}return y.forEach(Pr),C.forEach(is),t?t instanceof HTMLElement?(t.appendChild(c),Xu()):t(i,Xu):Xu(),i}Un.assign=pn;Un.fmtNum=hd;Un.rangeNum=bu;Un.rangeLog=Au;Un.rangeAsinh=cd;Un.orient=Cr;Un.pxRatio=bt;Un.join=xT;Un.fmtDate=dd,Un.tzDate=RT;Un.sync=G_;{Un.addGap=hA,Un.clipGaps=Ru;let n=Un.paths={points:Y_};n.linear=J_,n.stepped=pA,n.bars=mA,n.spline=_A}function yd(n,e=10,t=2500){return{step:e/t,bins:t,used:0,last:-1,base:null,times:new Float64Array(t),values:Object.fromEntries(n.map(s=>[s,new Float64Array(t).fill(NaN)]))}}function Nu(n){n.used=0,n.last=-1,n.base=null}function Sd(n,e,t){if(!Number.isFinite(e))return;n.base===null&&(n.base=e);let i=Math.floor((e-n.base)/n.step);if(i<n.last&&(Nu(n),n.base=e,i=0),i!==n.last){n.used===n.bins&&CA(n),n.times[n.used]=e;for(let o of Object.values(n.values))o[n.used]=NaN;n.used+=1,n.last=i}let r=n.used-1;for(let[o,a]of Object.entries(t)){let l=n.values[o];!l||!Number.isFinite(a)||Math.abs(l[r])>=Math.abs(a)||(l[r]=a)}}function CA(n){let e=n.bins>>3;n.times.copyWithin(0,e);for(let t of Object.values(n.values))t.copyWithin(0,e);n.used-=e}function Md(n,e){return[n.times.subarray(0,n.used),...e.map(t=>{let i=new Array(n.used);for(let s=0;s<n.used;s++)i[s]=Number.isNaN(n.values[t][s])?null:n.values[t][s];return i})]}function ex(n,e){let t=Object.keys(e),i=[["time [s]",...t.map(s=>e[s])].join(",")];for(let s=0;s<n.used;s++){let r=t.map(o=>Number.isFinite(n.values[o][s])?n.values[o][s]:"");i.push([n.times[s].toFixed(4),...r].join(","))}return i.join(`
`)+`
`}var el=10,nx=56,RA=45,ix=["force","force_x","force_y","force_z","torque","torque_x","torque_y","torque_z","penetration","stretch","energy","model_age","step_cpu","wake_late"],PA=["haptic_rate","contact_rate"],tx=["x","y","z"],IA=[{id:"force",title:"Force on the hand",unit:"N",least:.001,lines:["force","force_x","force_y","force_z"],names:["size",...tx],colours:["force","x","y","z"]},{id:"torque",title:"Torque on the hand",unit:"N m",least:1e-6,lines:["torque","torque_x","torque_y","torque_z"],names:["size",...tx],colours:["torque","x","y","z"]},{id:"penetration",title:"Penetration, below 0: gap",unit:"m",least:1e-9,lines:["penetration"],names:["depth"],colours:["contact"]},{id:"stretch",title:"Coupling stretch",unit:"m",least:1e-9,lines:["stretch"],names:["stretch"],colours:["hand"]},{id:"rates",title:"Contact and haptic rate",unit:"Hz",least:1,lines:["contact_rate","haptic_rate"],names:["contact","haptic"],colours:["contact","held"],slow:!0},{id:"age",title:"Age of the contact model",unit:"s",least:1e-6,lines:["model_age"],names:["age"],colours:["muted"]},{id:"energy",title:"Energy put in by the hand",unit:"J",least:1e-9,lines:["energy"],names:["energy"],colours:["torque"]}];function sx(n){let e={parent:n,fast:yd(ix,el),slow:yd(PA,el,600),plots:[],rows:0,now:0,marks:[],theme:null,floors:{Hz:1e3,s:.001},rested:0};for(let t of IA){let i=document.createElement("figure");i.className="plot";let s=document.createElement("figcaption"),r=document.createElement("output"),o=document.createElement("span");o.className="keys",s.append(Object.assign(document.createElement("span"),{textContent:t.title,className:"plot-title"}),o,r);let a=document.createElement("div");a.className="plot-area",i.append(s,a),n.append(i),e.plots.push({spec:t,box:i,area:a,keys:o,value:r,chart:null})}return e}function Du(n){n.theme=uu();for(let e of n.plots){e.chart?.destroy(),e.keys.replaceChildren(...e.spec.lines.length>1?e.spec.names.map((i,s)=>{let r=Object.assign(document.createElement("i"),{textContent:i});return r.style.color=Bt(e.spec.colours[s]),r}):[]);let t=e.area.clientWidth||300;e.chart=new Un(LA(n,e,t),Md(rx(n,e),e.spec.lines),e.area)}}var rx=(n,{spec:e})=>e.slow?n.slow:n.fast;function LA(n,{spec:e},t){let i={stroke:Bt("grid"),width:1};return{width:t,height:nx,legend:{show:!1},cursor:{sync:{key:"thigma"},points:{size:5},drag:{x:!1,y:!1}},padding:[6,6,0,0],scales:{x:{time:!1,range:()=>[n.now-el,n.now]},y:{range:(r,o,a)=>NA(o,a,Math.max(e.least,n.floors[e.unit]??0))}},axes:[{show:!0,size:4,grid:i,ticks:{show:!1},values:()=>[],space:40},{size:52,grid:i,ticks:{show:!1},space:12,gap:4,font:"10px system-ui, sans-serif",stroke:Bt("muted"),values:(r,o)=>DA(o,e)}],series:[{},...e.lines.map((r,o)=>({stroke:Bt(e.colours[o]),width:o===0||e.slow?1.6:.8,alpha:o===0||e.slow?1:.75,points:{show:!1},spanGaps:!1,fill:o===0&&!e.slow?`${Bt(e.colours[o])}1f`:void 0}))],hooks:{draw:[r=>UA(r,n)]}}}function NA(n,e,t){if(!Number.isFinite(n)||!Number.isFinite(e))return[0,t];let i=Math.min(0,n),s=Math.max(0,e,i+t),r=.1*(s-i);return[i<0?i-r:0,s+r]}function DA(n,e){let t=Math.max(...n.map(Math.abs)),{number:i,unit:s}=Fa(t,e.unit,e.least),r=t===0?1:Number(i)/t,o=n.length>3?2:1,a=n.length-1-(n.length-1)%o;return n.map((l,c)=>{if(c%o!==0)return null;let u=Number((l*r).toPrecision(2)).toString();return c===a?`${u} ${s}`:u})}function UA(n,e){let{ctx:t,bbox:i}=n;t.save(),t.lineWidth=1,t.setLineDash([3,3]);for(let{time:s,kind:r}of e.marks){if(s<e.now-el)continue;let o=n.valToPos(s,"x",!0);t.strokeStyle=Bt(r==="fault"?"bad":"mark"),t.beginPath(),t.moveTo(o,i.top),t.lineTo(o,i.top+i.height),t.stroke()}t.restore()}function ox(n,e,t){n.marks.push({time:e,kind:t}),n.marks=n.marks.filter(i=>i.time>e-el).slice(-40)}function ax(n,e,t,i){let s=e/i/10;Object.assign(n.floors,{N:s,"N m":.3*s*e,m:.25*t,J:.01*s*e})}function lx(n,e,t){let i=Object.fromEntries(t.map((r,o)=>[r,o])),s=ix.filter(r=>i[r]!==void 0);for(let r=0;r<e.rows;r++){let o=c=>e.values[r*e.columns+i[c]],a=Object.fromEntries(s.map(c=>[c,o(c)]));a.force=Math.hypot(a.force_x,a.force_y,a.force_z),a.torque=Math.hypot(a.torque_x,a.torque_y,a.torque_z);let l=e.time+o("t");Sd(n.fast,l,a),n.now=l}n.rows+=e.rows}function cx(n,e,t,i){Sd(n.slow,e,{haptic_rate:t,contact_rate:i})}function ux(n){Nu(n.fast),Nu(n.slow),n.marks=[]}function hx(n){let e=performance.now();if(e<n.rested||n.parent.hidden||n.parent.offsetParent===null)return;n.theme!==uu()&&Du(n);for(let i of n.plots){let s=Md(rx(n,i),i.spec.lines),r=i.area.clientWidth;r>0&&r!==i.chart.width&&i.chart.setSize({width:r,height:nx}),i.chart.setData(s),i.value.textContent=ui(FA(i,s),i.spec.unit,i.spec.least)}let t=performance.now();n.rested=t+Math.max(RA,9*(t-e))}function FA({chart:n},e){let t=n.cursor.idx??e[1].length-1;return t>=0?e[1][t]:NaN}function fx(n,e){let t=devicePixelRatio||1,i=n.plots.map(({spec:u,chart:h})=>({spec:u,canvas:h.root.querySelector("canvas")})),s=i[0].canvas.width,r=Math.round(22*t),o=Math.round(34*t),a=document.createElement("canvas");a.width=s,a.height=o+i.reduce((u,{canvas:h})=>u+r+h.height,0)+r;let l=a.getContext("2d");l.fillStyle=Bt("panel"),l.fillRect(0,0,a.width,a.height),l.fillStyle=Bt("ink"),l.font=`600 ${14*t}px system-ui, sans-serif`,l.fillText(e,10*t,22*t);let c=o;l.font=`${12*t}px system-ui, sans-serif`;for(let{spec:u,canvas:h}of i)l.fillText(u.title,10*t,c+15*t),l.drawImage(h,0,c+r),c+=r+h.height;return a}function dx(n){return ex(n.fast,{force_x:"force x on the hand [N]",force_y:"force y on the hand [N]",force_z:"force z on the hand [N]",torque_x:"torque x on the hand [N m]",torque_y:"torque y on the hand [N m]",torque_z:"torque z on the hand [N m]",penetration:"penetration [m]",stretch:"coupling stretch [m]",energy:"energy put in by the hand [J]",model_age:"age of the contact model [s]"})}var mx=[{id:"force",name:"Force",unit:"N",least:.001,help:"on the hand, as sent to the device"},{id:"torque",name:"Torque",unit:"N m",least:1e-6,help:"on the hand, about the handle"},{id:"penetration",name:"Depth",unit:"m",least:1e-9,help:"of the deepest contact: how far the surfaces pass into each other, or the gap between them; forces begin before they touch"},{id:"stretch",name:"Stretch",unit:"m",least:1e-9,help:"from the hand to where it holds the object: the spring that is felt"}];function gx(n){let e={tiles:{},lines:{}},t=mn("div","tiles");for(let{id:r,name:o,help:a}of mx){let l=mn("div",`tile ${r}`);l.title=a;let c=mn("span","number"),u=mn("span","unit"),h=mn("span","name",o);l.append(h,c,u),t.append(l),e.tiles[r]={title:h,number:c,unit:u}}let i=mn("p","situation"),s=mn("ul","lines");for(let r of["limit","rows","level","loop","contact","energy"]){let o=mn("li",`line ${r}`),a=mn("i","dot"),l=mn("span");o.append(a,l),s.append(o),e.lines[r]={line:o,text:l,dot:a}}return n.append(t,i,s),e.said=i,e}function mn(n,e="",t=""){return Object.assign(document.createElement(n),{className:e,textContent:t})}var tl=n=>Math.hypot(...n);function _x(n,e,t,i,s){if(!e||!i)return;let r=e.penetration>0,o={force:tl(e.force),torque:tl(e.torque),stretch:e.stretch,penetration:Math.abs(e.penetration)};for(let{id:u,unit:h,least:f}of mx){let p=Fa(o[u],h,f);n.tiles[u].number.textContent=p.number,n.tiles[u].unit.textContent=p.unit}n.tiles.penetration.title.textContent=e.penetration<0?"Gap":"Depth";let a=r||tl(e.contactForce)>0,l={object:i.object.name,statics:i.statics.map(u=>u.name),grasped:(e.bits&1)!==0,armed:(e.bits&6)===2,contacts:e.contactsFound,clusters:e.clusters.length,touching:a},c=(e.bits&xr.constrained)!==0;n.said.textContent=c?OA(n,l,{snapshot:e,state:t,scene:i,parameters:s}):Ym(l);for(let u of["limit","rows"])n.lines[u].line.hidden=!c;kA(n.lines.level,e,i),zA(n.lines.loop,e,t,i),VA(n.lines.contact,e,t),wi(n.lines.energy,"",`The hand has put in ${ui(e.energy,"J",1e-9)}.`)}function OA(n,e,{snapshot:t,state:i,scene:s,parameters:r}){let o=t.rows.filter(({presses:u})=>u).length,a=r.find(({name:u})=>u==="coupling_stiffness")?.value??null,l=i?.constraint??null,c={pressing:o,stiffness:a,stretch:t.stretch,force:tl(t.force)/s.workspace.force_scale,heldBack:l?.held_back??0,squeezed:l?.squeezed??0,say:ui};return wi(n.lines.limit,c.heldBack>.01||c.squeezed>.1?"warn":"good",Jm(c)),wi(n.lines.rows,l?.left_out>0||l?.halvings>0?"warn":"",BA(t,l)),Zm({...e,rows:l?.rows??t.rows.length,pressing:o,newtons:ui(tl(t.force),"N",.001),stiffness:a===null?null:ui(a,"N/m",1)})}function BA({rows:n},e){if(!e)return"Rows: not counted yet.";let t=[`${ti(e.in_model,"row")} in the contact model`];e.halvings>0&&t.push(`more were needed than fit, so its travel was halved ${e.halvings===1?"once":`${e.halvings} times`}`),e.left_out>0&&t.push(`${ti(e.left_out,"contact")} had no room: nothing may move`),Number.isFinite(e.travel)&&e.travel!==null&&t.push(`free for ${ui(e.travel,"m",1e-6)} around`);let i=Km(n);return i>0&&t.push(`${i} at the edge of ${i===1?"its cone":"their cones"}`),`${t.join("; ")}.`}function wi(n,e,t){n.line.dataset.mood=e,n.text.textContent!==t&&(n.text.textContent=t)}function kA(n,e,t){let i=pf(e.contacts),s=t.object.levels>1?` of ${t.object.levels} levels`:"",r="Level of detail: none in use, as nothing is near.",o=i[0]?.[0]===0?", the original surface":"";i.length===1&&(r=`Level of detail at the contacts: ${i[0][0]}${s}${o}.`),i.length>1&&(r=`Levels of detail at the contacts: ${i.map(([l])=>l).join(", ")}${s}; 0 is the finest.`);let a=jm(e.contacts);wi(n,"",a?`${r} Decided ${a}${a.includes("100 %")?"":"; there is nothing finer elsewhere"}.`:r),n.dot.style.background=i.length>0?vr(i[0][0]):""}function zA(n,e,t,i){let s=e.hapticRate,r=i.rate;if(t?.replay)return wi(n,"",`A recording of a loop at ${Math.round(r)} Hz.`);if(!Number.isFinite(s))return wi(n,"","Haptic loop: not measured yet.");if(t?.run!=="running")return wi(n,"",`Haptic loop: ${t?.run??"unknown"}.`);let o=s>=.99*r,a=t?.timing?.missed??null,l=a===null?"":`, ${ti(a,"frame")} missed`;return o?wi(n,"good",`The loop holds ${Math.round(r)} Hz${l}.`):wi(n,"warn",`The loop runs at ${Math.round(s)} of ${Math.round(r)} Hz${l}.`)}function VA(n,e,t){if(t?.replay){let a=Number.isFinite(e.modelAge)?` The model was ${ui(e.modelAge,"s",1e-6)} old.`:"";return wi(n,"",`Contacts are found again where the object was.${a}`)}if(!Number.isFinite(e.contactRate))return wi(n,"","Contacts: not measured yet.");let i=Number.isFinite(e.modelAge)?`; the model is ${ui(e.modelAge,"s",1e-6)} old`:"",r=t?.run==="running"?e.modelWeight>.99?"good":"warn":"",o=e.contactsDropped>0?`; ${e.contactsDropped} did not fit`:"";return wi(n,r,`Contacts found ${$s(e.contactRate)} times a second, ${ui(e.queryCpu,"s",1e-6)} each${i}${o}.`)}var px=[["object","the object"],["hand","where the hand holds it"],["coupling","coupling"],["near","rows near"],["press","rows that press"],["cone","friction cone"]];function xx(n,e){let t=!!e&&(e.bits&xr.constrained)!==0;if(n.hidden=!t,document.body.classList.toggle("constrained",t),!t)return;n.childElementCount===0&&n.replaceChildren(...px.map(([o,a])=>{let l=mn("span",`swatch row-key ${o}`);return l.append(mn("i"),mn("b","",a),mn("em")),l}));let i=e.rows.filter(({presses:o})=>o),s=(e.bits&1)!==0,r={object:null,hand:s?null:0,coupling:s?null:0,near:e.rows.length-i.length,press:i.length,cone:i.filter(({friction:o})=>o>0).length};px.forEach(([o],a)=>{let l=n.children[a];l.classList.toggle("active",r[o]!==0);let c=r[o]?`×${r[o]}`:"";l.lastChild.textContent!==c&&(l.lastChild.textContent=c)})}function vx(n,e,t,i=""){let s=Math.min(Ms.length,Math.max(t?.object.levels??1,1));if(n.childElementCount!==s+2){let a=Array.from({length:s},(l,c)=>{let u=mn("span","swatch",""),h=c===s-1&&t?.object.levels>s?"+":"";return u.append(mn("i"),mn("b","",`${c}${h}`),mn("em")),u.firstChild.style.background=vr(c),u});n.replaceChildren(mn("span","legend-title","Level at contacts"),...a,mn("span","legend-browsed"))}let r=new Map;for(let[a,l]of pf(e?.contacts??[])){let c=Math.min(a,Ms.length-1);r.set(c,(r.get(c)??0)+l)}let o=i?`Patches of ${i}`:"";n.lastChild.textContent!==o&&(n.lastChild.textContent=o),[...n.children].slice(1,-1).forEach((a,l)=>{let c=r.get(l)??0;a.classList.toggle("active",c>0);let u=c>0?`×${c}`:"";a.lastChild.textContent!==u&&(a.lastChild.textContent=u)})}function ns(n,e="",t=""){return Object.assign(document.createElement(n),{className:e,textContent:t})}function Sx(n,e){let t=ns("p","note","Choose a level to see its convex patches, each in a colour of its own. What contacts use at this moment stands in the colours of the legend."),i=ns("div");return n.append(t,i),{list:i,browse:e,rows:[],scene:null}}function Mx(n,e){n.scene=e;let t=[e.object,...e.statics];n.rows=t.map((i,s)=>GA(n,i,s)),n.list.replaceChildren(...n.rows.map(i=>i.box))}function GA(n,e,t){let i=ns("section","level-row"),s=ns("div","level-head"),r=ns("i",t===0?"held":"fixed");s.append(r,ns("h3","",e.name),ns("span","note",ti(e.levels,"level")));let o=ns("div","chips");o.setAttribute("role","radiogroup"),o.setAttribute("aria-label",`Level of the ${e.name}`);let a=ns("p","note"),l={box:i,about:e,body:t,caption:a,chips:[],level:null},c=[null,...(e.level_list??[]).keys()];for(let u of c){let h=Object.assign(ns("button","chip-button",u===null?"as it is":String(u)),{type:"button"});h.setAttribute("role","radio"),h.setAttribute("aria-label",u===null?`${e.name} as it is`:`${e.name}, level ${u}`),u!==null&&u>0&&e.level_list[u].free&&h.classList.add("free"),h.addEventListener("click",()=>yx(n,l,u)),l.chips.push({chip:h,level:u}),o.append(h)}return i.append(s,o,a),yx(n,l,null),l}function yx(n,e,t){let i=e.level!==t;e.level=t;for(let{chip:s,level:r}of e.chips)s.setAttribute("aria-checked",String(r===t));e.caption.textContent=HA(e.about,t),i&&n.browse(e.body,t)}function HA(n,e){if(e===null)return"";let t=n.level_list[e];return e===0?`The original surface: ${ti(t.triangles,"triangle")} in ${ti(t.patches,"convex patch","convex patches")}.`:Uf({about:n},e)?`${ti(t.triangles,"triangle")} in ${ti(t.patches,"convex patch","convex patches")}; nowhere more than ${ui(t.deviation,"m",1e-9)} off the original.`:`${ti(t.patches,"group")} of patches below, merged pairwise. No surface of its own: contacts here are with convex hulls.`}function bx(n){return n.rows.filter(e=>e.level!==null).map(e=>`${e.about.name} ${e.level}`).join(", ")}function Yt(n,e="",t=""){return Object.assign(document.createElement(n),{className:e,textContent:t})}var Uo=(n,e,t="")=>{let i=Object.assign(Yt("button",t,n),{type:"button"});return i.addEventListener("click",e),i},WA=[["millimetres",.001],["centimetres",.01],["inches",.0254],["metres",1]];function Tx(n,{ask:e,send:t,room:i,limit:s}){let r={dialog:n,ask:e,send:t,room:i,limit:s,menu:{scenes:[],recordings:[]},name:"",model:null,busy:null};n.addEventListener("click",o=>{o.target===n&&n.close()});for(let o of["dragenter","dragover"])addEventListener(o,a=>{[...a.dataTransfer?.types??[]].includes("Files")&&(a.preventDefault(),document.body.classList.add("dropping"))});return addEventListener("dragleave",o=>{o.relatedTarget||document.body.classList.remove("dropping")}),addEventListener("drop",o=>{o.preventDefault(),document.body.classList.remove("dropping");let a=o.dataTransfer?.files?.[0];a&&Rx(r,a)}),r}function Ax(n,e){n.menu=e,n.dialog.open&&!n.model&&Cx(n)}function Ex(n,e){n.name=e,n.model=null,Cx(n),n.dialog.open||n.dialog.showModal()}function Cx(n){let{scenes:e,recordings:t}=n.menu,i=a=>{let l=Yt("div","open-list");return l.append(...a.map(({name:c,title:u})=>{let h=Uo("",()=>XA(n,c),"open-item");return h.append(Yt("b","",u||c)),u&&u!==c&&h.append(Yt("span","note",c)),h.setAttribute("aria-current",String(c===n.name)),h})),l},s=Object.assign(Yt("input"),{type:"file",accept:".obj,.stl,.ply,.off",id:"mesh-file"});s.addEventListener("change",()=>{s.files[0]&&Rx(n,s.files[0])});let r=Yt("label","drop-zone");r.htmlFor=s.id,r.append(Yt("b","","A mesh of your own"),Yt("span","note","Drop an OBJ, STL or PLY file anywhere on the page, or click to choose one."),s);let o=[Yt("h2","","Open"),r,Yt("h3","","Scenes"),i(e)];t.length>0&&o.push(Yt("h3","","Recordings"),i(t)),n.dialog.replaceChildren(...o,bd(n,[Uo("Cancel",()=>n.dialog.close())]))}function bd(n,e,t=""){let i=Yt("div","dialog-foot"),s=Yt("p","refusal",t);return s.setAttribute("role","alert"),i.append(s,...e),n.said=s,i}async function XA(n,e){(await wd(n,{type:"open",value:e})).ok&&n.dialog.close()}async function wd(n,e){if(n.busy)return{ok:!1};n.dialog.classList.add("busy"),n.busy=n.ask(e);let t=await n.busy;return n.busy=null,n.dialog.classList.remove("busy"),!t.ok&&n.said&&(n.said.textContent=t.reason??"The program refused."),t}async function Rx(n,e){for(;n.busy;)await n.busy;n.model={name:e.name};let t=Object.assign(Yt("progress"),{max:1,value:0});n.dialog.replaceChildren(Yt("h2","",e.name),Yt("p","note","Sending and looking at it …"),t,bd(n,[Uo("Cancel",()=>n.dialog.close())])),n.dialog.open||n.dialog.showModal();let i=new Uint8Array(await e.arrayBuffer()),s=wd(n,{type:"upload",name:e.name.slice(-120),value:i.length});await qA(n,i,t),await s}async function qA(n,e,t){let i=Math.max(1024,Math.min(n.limit(),65536)-64);for(let s=0;s<e.length&&n.busy;){for(let r=0;r<8&&s<e.length&&n.room()<4*i;r++){if(!n.send(lg(e.subarray(s,s+i))))return;s+=i}t.value=Math.min(1,s/e.length),await new Promise(r=>setTimeout(r,10))}}function Px(n,e){n.model=e;let{report:t}=e,i=t.verdict==="usable",s=t.verdict==="repairable",r=Yt("p",`verdict ${t.verdict}`,{usable:"Ready to use",repairable:"Needs repair first",rejected:"Cannot be used"}[t.verdict]??t.verdict),o=Yt("p","",`${ti(t.triangles,"triangle")}, ${t.closed?"closed":"open"}, ${ti(t.components,"part")}.`),a=Yt("ul","reasons");for(let S of[...t.reasons,...t.warnings])a.append(Yt("li","",S));let l=Object.assign(Yt("select"),{id:"mesh-unit"}),c=[...WA.map(([S,d])=>[`${S} (${wx(t,d)})`,d]),[`whatever makes it as large as the object (${wx(t,e.object_radius/t.radius)})`,e.object_radius/t.radius]];l.append(...c.map(([S,d])=>new Option(S,String(d)))),l.value=String(e.unit);let u=Object.assign(Yt("label","","Its unit is "),{htmlFor:l.id}),h=Yt("p","unit-choice");h.append(u,l);let f=S=>async()=>{(await wd(n,{type:"place",name:S,value:Number(l.value),repair:s})).ok&&n.dialog.close()},p=s?"Repair and ":"",g=[Uo("Cancel",()=>n.dialog.close())];(i||s)&&g.push(Uo(p?"Repair and touch it":"Touch it",f("touch")),Uo(p?"Repair and hold it":"Hold it",f("hold"),"primary")),n.dialog.replaceChildren(Yt("h2","",e.name),r,o,a,...i||s?[h]:[],bd(n,g)),n.dialog.open||n.dialog.showModal()}function wx(n,e){let t=e*Math.max(...n.bounds.max.map((i,s)=>i-n.bounds.min[s]));return Number.isFinite(t)?t<.9995?`${$s(1e3*t)} mm`:`${$s(t)} m`:"–"}function Ix(n,e){let t={parent:n,act:e,held:!1,waiting:!1,next:null};t.play=Si("pause","Pause","P",e.pause),t.slider=Object.assign(document.createElement("input"),{type:"range",min:0,max:1,step:"any"}),t.slider.setAttribute("aria-label","Time in the recording"),t.text=document.createElement("output"),t.slider.addEventListener("input",()=>{t.held=!0,Lx(t,Number(t.slider.value))});for(let i of["change","blur"])t.slider.addEventListener(i,()=>{t.held=!1});return n.append(t.play,t.slider,t.text),t}async function Lx(n,e){if(n.waiting){n.next=e;return}n.waiting=!0,await n.act.seek(e),n.waiting=!1;let t=n.next;n.next=null,t!==null&&Lx(n,t)}function Nx(n,e,t){let i=e?.replay??null;if(n.parent.hidden=!i,!i)return;let s=n.held||n.waiting?Number(n.slider.value):t?.time??0;n.slider.max=i.seconds,!n.held&&!n.waiting&&(n.slider.value=s),n.slider.setAttribute("aria-valuetext",`${gr(s)} of ${gr(i.seconds)}`),n.text.textContent=`${gr(s)} / ${gr(i.seconds)}`;let r=e.run==="paused";Ua(n.play,r?"play":"pause"),Mo(n.play,r?"Play":"Hold","P")}function Dx(n,e,t){let i=e.map(([a,l])=>{let c=Object.assign(document.createElement("button"),{type:"button",textContent:l});return c.setAttribute("role","tab"),c.setAttribute("aria-controls",a),c.addEventListener("click",()=>o(a)),{id:a,tab:c}}),s=Object.assign(document.createElement("span"),{className:"grow"}),r=t.map(([a,l,c])=>{let u=Object.assign(document.createElement("button"),{type:"button",textContent:a,title:l,className:"quiet"});return u.setAttribute("aria-label",l),u.addEventListener("click",c),u});function o(a){for(let{id:l,tab:c}of i)c.setAttribute("aria-selected",String(l===a)),document.getElementById(l).hidden=l!==a;for(let l of r)l.hidden=a!==e[0][0]}return n.append(...i.map(({tab:a})=>a),s,...r),o(e[0][0]),o}var nn=n=>document.getElementById(n),$A=50,_e={connected:!1,hello:null,scene:null,meshes:new Map,state:null,parameters:[],snapshot:null,refusal:null,counts:{snapshot:0,channels:0,mesh:0,event:0},holding:!1,turned:!1,trouble:null,progress:null,fresh:!1,asking:!1,sent:0,faultName:()=>_e.hello?.faults?.[_e.snapshot?.fault??0]??"fault"},jn=ug(),YA=ng(),Lt=null,pi=null,Bi=sx(nn("plots")),ZA=gx(nn("readouts")),Vx=Sx(nn("levels"),(n,e)=>Lt&&Sr(Lt)[n]&&a0(Lt,Sr(Lt)[n],e)),Td=Tx(nn("opener"),{ask:n=>Mr(pi,n),send:n=>x0(pi,n),room:()=>v0(pi),limit:()=>_e.hello?.max_message??4096}),JA=b0(nn("parameters"),(n,e)=>Mr(pi,{type:"set",name:n,value:e}));async function Rr(n){let e=await Mr(pi,n);return e.ok||(_e.refusal={text:e.reason??"The program refused.",until:performance.now()/1e3+6}),e}var Kn={open:()=>nn("opener").open?nn("opener").close():Ex(Td,_e.scene?.name??""),seek:n=>Rr({type:"seek",value:n}),pause:()=>Rr({type:"pause",value:_e.state?.run!=="paused"}),step:()=>Rr({type:"step",value:1}),reset:()=>Rr({type:"reset"}),record:()=>Rr({type:"record",value:!_e.state?.recording}),device:n=>Rr({type:"use_device",value:n}).then(e=>nl(e.ok&&n.startsWith("web:"))),help:()=>nn("help").open?nn("help").close():nn("help").showModal(),theme:()=>jA(),view:n=>{Lt&&(c0(Lt,{[n]:!Lt.options[n]}),mf(Ad,Lt.options))},fit:()=>Lt&&iu(Lt.view)},Ad=Qm(Kn),KA=Ix(nn("replay"),Kn),jA=gg(()=>{Lt&&_u(Lt),Du(Bi)}),QA={hello:n=>{_e.hello=n},scene:n=>{_e.scene=n,_e.snapshot=null,_e.fresh=!1,_e.meshes.clear(),Mx(Vx,n),js("Loading the objects …")},mesh:n=>{_e.counts.mesh+=1,_e.meshes.set(n.number,n),[_e.scene.object,..._e.scene.statics].map(t=>t.mesh).every(t=>_e.meshes.has(t))&&(Lt&&r0(Lt,_e.scene,_e.meshes),js(_e.trouble))},level:n=>{Lt&&o0(Lt,n)},menu:n=>Ax(Td,n),model:n=>Px(Td,n),progress:({what:n,share:e})=>{_e.progress=n,n?js(`${n[0].toUpperCase()}${n.slice(1)} …`,e):js(_e.trouble)},parameters:n=>{_e.parameters=n.list,w0(JA,n.list)},state:n=>{_e.state&&_e.state.session!==n.session&&eE(),_e.state=n,nl(n.holder==="you")},event:n=>{_e.counts.event+=1,A0(nn("events"),n),ox(Bi,n.time,n.kind),["recording_ended","held_back","squeezed"].includes(n.kind)&&(_e.refusal={text:`${ou(n)}.`,until:performance.now()/1e3+10})},channels:n=>{_e.counts.channels+=1,lx(Bi,n,["t",..._e.hello.channels.map(e=>e.name).filter(e=>e!=="t")])},snapshot:n=>{_e.counts.snapshot+=1;let e=n.bits&~(_e.snapshot?.bits??0);_e.snapshot=n,e&xr.fault&&(jn.clutch=!1),_e.fresh=!0,n.metresPerNewton>0&&ax(Bi,_e.scene.object.radius,_e.scene.tolerance,n.metresPerNewton),cx(Bi,n.time,n.hapticRate,n.contactRate)}};function eE(){jn.clutch=!1,ux(Bi),nn("events").replaceChildren()}function js(n,e=null){if(nn("veil").hidden=!n,!n)return;let t=Object.assign(document.createElement("p"),{textContent:n}),i=Object.assign(document.createElement("progress"),{max:1,value:e??0});nn("veil").replaceChildren(t,...e===null?[]:[i])}function tE(n){_e.connected=!1,nl(!1),jn.clutch=!1,yf(jn),document.body.classList.add("lost"),_e.progress=null,js(`${n} Nothing is felt or shown any more. ${pi?.stopped?"":"Trying again …"}`)}function nE(){_e.connected=!0,document.body.classList.remove("lost"),js(null)}var Fo={get stage(){return Lt},hand:jn,workspace:()=>_e.scene.workspace,grasp:()=>_e.snapshot?.grasp??[0,0,0],mayMove:()=>_e.connected&&_e.hello?.may_control!==!1&&!!_e.state?.device.startsWith("web:")&&_e.state.holder!=="other"&&_e.state.run!=="ended"&&!_e.state.replay&&!!_e.snapshot,async press(){if(jn.clutch&&_e.holding||_e.asking)return;_e.asking=!0;let n=vf(jn);_e.holding||nl((await Rr({type:"hold",value:!0})).ok),_e.asking=!1,_e.holding&&(bo(jn,performance.now()/1e3,n),jn.clutch=!0,Uu())},moved:n=>{_e.turned||=n},give:Gx,letGo:()=>{jn.clutch=!1,Uu()}};function nl(n){_e.holding&&!n&&_0(pi),_e.holding=n}function Gx(){if(!_e.holding||!_e.connected)return;let n=yf(jn);g0(pi,n),_e.sent+=n.length}function Uu(){_e.holding&&(bo(jn,performance.now()/1e3),Gx())}function Hx(){_e.holding&&(Fo.letGo(),nl(!1),Mr(pi,{type:"hold",value:!1}))}document.addEventListener("visibilitychange",()=>{document.hidden&&Hx()});addEventListener("pagehide",Hx);addEventListener("keydown",n=>{if(n.target.closest?.("input, select, textarea")||n.ctrlKey||n.metaKey||n.altKey)return;let i={" ":()=>jn.clutch?Fo.letGo():Fo.mayMove()&&Fo.press(),p:Kn.pause,".":Kn.step,r:Kn.reset,f:Kn.fit,o:Kn.open,"?":Kn.help,h:Kn.help,l:()=>Kn.view("wireframe"),g:()=>Kn.view("ghost"),c:()=>Kn.view("contacts"),a:()=>Kn.view("forces")}[n.key.length===1?n.key.toLowerCase():""];!i||n.key===" "&&n.target.closest?.("button")||(n.preventDefault(),i())});function iE(){try{Lt=s0(nn("scene"),new URLSearchParams(location.search).get("picture"))}catch(n){return _e.trouble="This browser shows no WebGL 2, so there is no picture; numbers and plots work. Hardware acceleration may be off in its settings.",js(_e.trouble),console.warn(String(n.message??n)),null}return Lt.wants=(n,e)=>Mr(pi,{type:"level",mesh:n,value:e}),_u(Lt),mf(Ad,Lt.options),new ResizeObserver(()=>zf(Lt)).observe(nn("stage")),zf(Lt),d0(Fo)}function Ux(n,e){let t=Object.assign(document.createElement("a"),{href:URL.createObjectURL(e),download:n});t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}var Fx=n=>`thigma-${(_e.snapshot?.time??0).toFixed(1)}s.${n}`,Ox=iE();E0(nn("help"));var sE=()=>`${_e.scene?.title??""}, to ${(_e.snapshot?.time??0).toFixed(1)} s`;Dx(nn("tabs"),[["plots","Plots"],["parameters","Parameters"],["levels","Levels"],["events","Events"]],[["PNG","Save the plots as a picture",()=>fx(Bi,sE()).toBlob(n=>Ux(Fx("png"),n))],["CSV","Save the plots as a table",()=>Ux(Fx("csv"),new Blob([dx(Bi)],{type:"text/csv"}))]]);Du(Bi);js("Connecting …");var Bx=/^#token=([0-9a-f]+)$/.exec(location.hash)?.[1];pi=m0(`${location.protocol==="https:"?"wss":"ws"}://${location.host}/live${Bx?`?token=${Bx}`:""}`,{message:n=>QA[n.type??n.kind]?.(n),opened:nE,lost:tE});setInterval(Uu,$A);var kx=performance.now(),zx=0,Wx=0;function Xx(n){requestAnimationFrame(Xx);let e=_e.snapshot?Math.hypot(..._e.snapshot.force):0;Ox&&p0(Ox,(n-kx)/1e3,e,rE()),kx=n,Uu(),Lt&&_e.fresh&&Bf(Lt,_e.snapshot),_e.fresh=!1,Lt&&u0(Lt)&&(Wx+=1),zx+=1,hx(Bi),zx%6===0&&oE(n/1e3,e)}function rE(){let n=_e.snapshot?.metresPerNewton;return n>0&&_e.scene?_e.scene.object.radius/n:3}function oE(n,e){eg(Ad,_e),_x(ZA,_e.snapshot,_e.state,_e.scene,_e.parameters),xx(nn("row-legend"),_e.snapshot),vx(nn("legend"),_e.snapshot,_e.scene,bx(Vx)),Nx(KA,_e.state,_e.snapshot),tg(nn("hint"),ig(YA,_e,{now:n,newtons:e,holding:_e.holding&&jn.clutch,turned:_e.turned},Kn))}requestAnimationFrame(Xx);window.thigma={session:_e,hand:jn,plots:Bi,player:Fo,act:Kn,ask:n=>Mr(pi,n),get stage(){return Lt},get link(){return pi},get drawn(){return Wx}};})();
